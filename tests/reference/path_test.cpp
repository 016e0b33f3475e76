// Volumetric light transport against conservation of energy, closed forms and itself.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "bssrdf/fresnel.h"
#include "reference/path/path_run.h"
#include "reference/path/path_tracer.h"
#include "reference/path_fixture.h"
#include "reference/truth.h"

namespace opaline::reference {
namespace {

using std::numbers::pi;

double allFlux(const PathTracer& tracer) {
  return tracer.leftFlux(0, Order::Unscattered) + tracer.leftFlux(0, Order::Single) +
         tracer.leftFlux(0, Order::Multiple);
}

// Without absorption, all light that enters leaves. The flux that enters a sphere in parallel light
// is by quadrature.
TEST(PathTest, WhatEntersLeavesWithoutAbsorption) {
  Scene scene = sceneOf(bodyOf(test::sphere({1, 2, 3}, 3, 5), 1.5, 0, 1.4));
  scene.lighting.directional = {{{0.3F, -0.4F, 0.8F}, {2, 2, 2}}};
  const Geometry geometry(scene);
  PathTracer tracer(geometry, {.bounces = 0});
  tracer.run(40000);
  double entering = 0;
  constexpr int steps = 20000;
  for (int i = 0; i < steps; ++i) {
    const double sine2 = (i + 0.5) / steps;  // squared distance from the axis, over the radius
    entering += (1 - bssrdf::fresnelReflectance(1.4, std::sqrt(1 - sine2))) / steps;
  }
  const double expected = 2 * pi * 9 * entering;
  // The only remaining randomness is whether a particle enters.
  EXPECT_NEAR(allFlux(tracer) / expected, 1, 3 * std::sqrt((1 - entering) / 40000) + 0.001);
  EXPECT_LT(tracer.lostShare(0), 1e-4);
}

// The number of particles that hit a ball must match the light of a spot that shines past its rim.
TEST(PathTest, ASpotLightShinesIntoItsCone) {
  const double radius = 3;
  const double distance = 10;
  Scene scene = sceneOf(bodyOf(test::sphere({0, 0, 0}, static_cast<float>(radius), 5), 1, 0, 1.4));
  // 5° off the middle of the ball, whose radius appears under 17.5°.
  const SpotLight light{{0, 0, 10}, {0.0871557F, 0, -0.9961947F}, {2, 2, 2}, 8, 20};
  scene.lighting.spots = {light};
  const Geometry geometry(scene);
  const Emitter emitter(geometry, 0);
  constexpr int particles = 100'000;
  int met = 0;
  for (int i = 0; i < particles; ++i) {
    Random random(5, static_cast<std::uint64_t>(i));
    const Flight flight = emitter.emit(random);
    if (geometry.closestHit(flight.origin, flight.direction)) ++met;
  }
  const auto cosineOf = [](double degrees) { return std::cos(degrees * pi / 180); };
  const double least = std::sqrt(1 - radius * radius / (distance * distance));
  double expected = 0;
  constexpr int steps = 400;
  for (int i = 0; i < steps; ++i) {
    const double cosine = least + (1 - least) * (i + 0.5) / steps;
    const double sine = std::sqrt(1 - cosine * cosine);
    for (int k = 0; k < steps; ++k) {
      const double across = sine * std::cos(2 * pi * (k + 0.5) / steps);
      const double toAxis = across * 0.0871557 + cosine * 0.9961947;
      const double part =
          std::clamp((toAxis - cosineOf(20)) / (cosineOf(8) - cosineOf(20)), 0.0, 1.0);
      expected += 2 * part * part * 2 * pi * (1 - least) / (steps * steps);
    }
  }
  const double found = emitter.flux() * met / particles;
  EXPECT_NEAR(found, expected, 4 * emitter.flux() * std::sqrt(double{particles}) / particles);
  EXPECT_NEAR(found / expected, 1, 0.01);
}

// The number of particles that hit a small ball must match the light of a large lamp: L π (r / d)²
// on a surface facing a sphere, times the ball's cross-section. A disc facing away gives none.
TEST(PathTest, AreaLightsShineOnABall) {
  const double radius = 0.5;
  Scene scene = sceneOf(bodyOf(test::sphere({0, 0, 0}, static_cast<float>(radius), 5), 1, 0, 1.4));
  const auto shares = [&](const AreaLight& light) {
    scene.lighting.areas = {light};
    const Geometry geometry(scene);
    const Emitter emitter(geometry, 0);
    constexpr int particles = 100'000;
    int met = 0;
    for (int i = 0; i < particles; ++i) {
      Random random(5, static_cast<std::uint64_t>(i));
      const Flight flight = emitter.emit(random);
      if (geometry.closestHit(flight.origin, flight.direction)) ++met;
    }
    return emitter.flux() * met / particles;
  };
  const double crossSection = pi * radius * radius;
  EXPECT_NEAR(shares(SphereLight{{0, 0, 20}, 5, {2, 2, 2}}) / (2 * pi / 16 * crossSection), 1,
              0.02);
  // For a disc above a point, all light that passes a small ball: 2π (1 - cos) L.
  const DiscLight disc{{0, 20, 0}, {0, -1, 0}, 5, {2, 2, 2}};
  const double cosine = 20 / std::sqrt(425.0);
  EXPECT_NEAR(shares(disc) / (2 * 2 * pi * (1 - cosine) * crossSection), 1, 0.02);
  EXPECT_EQ(shares(DiscLight{{0, 20, 0}, {0, 1, 0}, 5, {2, 2, 2}}), 0);
  EXPECT_NEAR(shares(DiscLight{{0, 20, 0}, {0, 1, 0}, 5, {2, 2, 2}, true}) / shares(disc), 1, 0.02);
}

// In even light a body without absorption cannot be told from its surroundings: as much light
// leaves it, through its surface or reflected, as falls on it.
TEST(PathTest, WhiteFurnace) {
  Scene scene = sceneOf(bodyOf(test::sphere({0, 0, 0}, 2, 4), 2, 0, 1.3));
  scene.lighting.ambient = {1, 1, 1};
  const Geometry geometry(scene);
  PathTracer tracer(geometry, {});
  const int particles = 60000;
  tracer.run(particles);
  // F̄_t of the flux π on each area of the convex body enters, and as much must leave.
  const double area = 4 * pi * 4;
  const double entering = bssrdf::meanTransmittance(1.3);
  EXPECT_NEAR(allFlux(tracer) / (pi * area * entering), 1,
              3 * std::sqrt((1 - entering) / particles) + 0.003);
}

/// A rectangle on a side of the box of half edges 2, 1.5 and 1, given by the axis perpendicular to
/// it.
struct Window {
  std::size_t axis = 0;
  std::array<double, 2> low{};
  std::array<double, 2> high{};

  double area() const { return (high[0] - low[0]) * (high[1] - low[1]); }
  std::size_t u() const { return (axis + 1) % 3; }
  std::size_t v() const { return (axis + 2) % 3; }
  bool holds(const Vector& p) const {
    constexpr std::array<double, 3> half{2, 1.5, 1};
    return std::abs(p[axis] - half[axis]) < 1e-6 && p[u()] >= low[0] && p[u()] < high[0] &&
           p[v()] >= low[1] && p[v()] < high[1];
  }
};

/// Share of diffuse light through one window that leaves through the other.
double shareThrough(const Walk& walk, const Window& in, const Window& out, int particles) {
  constexpr std::array<double, 3> half{2, 1.5, 1};
  int left = 0;
  for (int i = 0; i < particles; ++i) {
    Random random(21 + in.axis, static_cast<std::uint64_t>(i));
    Vector place{};
    place[in.axis] = half[in.axis];
    place[in.u()] = in.low[0] + (in.high[0] - in.low[0]) * random();
    place[in.v()] = in.low[1] + (in.high[1] - in.low[1]) * random();
    const double cosine = std::sqrt(random());
    const double sine = std::sqrt(1 - cosine * cosine);
    const double angle = 2 * pi * random();
    Vector direction{};
    direction[in.axis] = -cosine;
    direction[in.u()] = sine * std::cos(angle);
    direction[in.v()] = sine * std::sin(angle);
    walk.follow({place - 0.01 * direction, direction}, random,
                [&](const Leaving& leaving) { left += out.holds(leaving.point.position) ? 1 : 0; });
  }
  return static_cast<double>(left) / particles;
}

// Helmholtz: diffuse light exchanged between two windows is, per area, equal both ways, whatever
// lies between.
TEST(PathTest, WindowsExchangeLightAlikeBothWays) {
  const Scene scene = sceneOf(bodyOf(test::box({0, 0, 0}, {2, 1.5F, 1}, 2), 1.1, 0.05, 1.4));
  const Geometry geometry(scene);
  const DistanceBound bound(scene);
  const std::vector<Interior> interiors{{1.15, 1.1 / 1.15, 0, 1.4}};
  const Walk walk(geometry, bound, interiors, 0);
  const Window top{2, {0.2, -0.9}, {1.9, 0.8}};
  const Window side{0, {-0.4, -0.9}, {0.9, 0.3}};
  constexpr int particles = 60000;
  const double there = shareThrough(walk, top, side, particles);
  const double back = shareThrough(walk, side, top, particles);
  const double tolerance = 3 * std::hypot(top.area() * std::sqrt(there / particles),
                                          side.area() * std::sqrt(back / particles));
  EXPECT_NEAR(top.area() * there, side.area() * back, tolerance);
  EXPECT_GT(there * particles, 1000);  // fewer would prove little
}

TEST(PathTest, SameSeedSamePictureWhateverTheThreads) {
  Scene scene = sceneOf(bodyOf(test::sphere({0, 0, 0}, 4, 3), 1, 0.02, 1.3));
  scene.lighting.directional = {{{0, 0, 1}, {1, 1, 1}}};
  scene.lighting.points = {{{0, 20, 0}, {100, 100, 100}}};
  const Geometry geometry(scene);
  const auto trace = [&](std::size_t threads, std::vector<std::uint64_t> steps) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    PathTracer tracer(geometry, {.seed = 5});
    for (const std::uint64_t step : steps) tracer.run(step);
    std::vector<double> values;
    for (std::uint32_t t = 0; t < scene.bodies[0].triangles.size(); ++t)
      for (const double value :
           tracer.exitance(geometry.pointOn(0, t, {1.0 / 3, 1.0 / 3, 1.0 / 3})).value)
        values.push_back(value);
    return values;
  };
  EXPECT_EQ(trace(1, {9000}), trace(2, {4000, 5000}));
}

TEST(PathTest, ExitanceOfLightThatScatteredOnceOrMoreIsItsFlux) {
  Scene scene = sceneOf(bodyOf(test::sphere({0, 0, 0}, 4, 2), 1, 0.3, 1.3));
  scene.lighting.directional = {{{0, 0, 1}, {1, 1, 1}}};
  const Geometry geometry(scene);
  const auto fluxShown = [&](Scattered shown) {
    PathTracer tracer(geometry, {.seed = 5, .shown = shown});
    tracer.run(8000);
    double flux = 0;
    for (std::size_t cell = 0; cell < tracer.cells().count(); ++cell)
      flux += tracer.cells().areaMm2(cell) * tracer.exitanceOfCell(cell).value[0];
    return flux;
  };
  PathTracer both(geometry, {.seed = 5});
  both.run(8000);
  const double once = both.leftFlux(0, Order::Single);
  const double more = both.leftFlux(0, Order::Multiple);
  EXPECT_GT(once, 0);
  EXPECT_GT(more, once);
  EXPECT_NEAR(fluxShown(Scattered::Both), once + more, 1e-9 * more);
  EXPECT_NEAR(fluxShown(Scattered::Single), once, 1e-9 * more);
  EXPECT_NEAR(fluxShown(Scattered::Multiple), more, 1e-9 * more);
}

// In even light a white body is equally bright in all directions, including the camera's.
TEST(PathTest, ConeCountsWhatLeavesTowardsTheCamera) {
  constexpr float radiusMm = 8;
  Scene scene = sceneOf(bodyOf(test::sphere({0, 0, 0}, radiusMm, 3), 0.8, 0, 1.3));
  scene.lighting.ambient = {1, 1, 1};
  scene.camera.positionMm = {0, 0, 400};
  const Geometry geometry(scene);
  PathTracer tracer(geometry, {.seed = 3, .cellMm = 2, .coneDegrees = 25});
  tracer.run(30000);
  // Areas seen head-on and at a slant.
  std::array<double, 2> sums{};
  std::array<double, 2> squares{};
  std::array<double, 2> areas{};
  tracer.cells().forEachPart(scene, [&](const Cells::Part& part) {
    const double cosine = part.normal[2];
    if (cosine < 0.15) return;
    const std::size_t which = cosine > 0.75 ? 0 : 1;
    const Exitance exitance = tracer.exitanceOfCell(part.cell);
    areas[which] += part.areaMm2;
    sums[which] += part.areaMm2 * exitance.value[0];
    squares[which] +=
        part.areaMm2 * std::pow(exitance.error[0], 2) * tracer.cells().areaMm2(part.cell);
  });
  const double entered = pi * bssrdf::meanTransmittance(1.3);
  for (std::size_t i = 0; i < 2; ++i) {
    const double error = std::sqrt(squares[i]) / areas[i];
    EXPECT_LT(error, 0.05 * entered);
    EXPECT_NEAR(sums[i] / areas[i], entered, 3 * error) << i;
  }
}

// Against how far apart pictures of the same light are in fact.
TEST(PathTest, TheErrorOfAPictureIsWhatItsBlocksDifferBy) {
  Scene scene = sceneOf(bodyOf(test::sphere({0, 0, 0}, 4, 3), 1, 0.02, 1.3));
  scene.camera.positionMm = {0, 0, 30};
  scene.lighting.ambient = {1, 1, 1};
  const Geometry geometry(scene);
  const Irradiance irradiance(geometry);
  constexpr int edge = 40;
  constexpr std::size_t blocks = 25;
  PictureOptions picture;
  picture.width = picture.height = edge;
  picture.aov = Aov::Exitance;
  const auto meansOfBlocks = [&](const PathTracer& tracer) {
    const Image image = pathTruth(tracer, geometry, irradiance, picture).image;
    std::array<double, 3 * blocks> means{};
    for (std::size_t i = 0; i < image.rgba.size() / 4; ++i) {
      const std::size_t block = i / edge / 8 * 5 + i % edge / 8;
      for (std::size_t c = 0; c < 3; ++c)
        means[3 * block + c] += static_cast<double>(image.rgba[4 * i + c]) / 64;
    }
    return means;
  };
  constexpr int pairs = 12;
  double squares = 0;
  double said = 0;
  for (std::uint64_t seed = 1; seed <= pairs; ++seed) {
    PathTracer a(geometry, {.seed = 2 * seed});
    PathTracer b(geometry, {.seed = 2 * seed + 1});
    a.run(1000);
    b.run(1000);
    const auto meansA = meansOfBlocks(a);
    const auto meansB = meansOfBlocks(b);
    for (std::size_t i = 0; i < meansA.size(); ++i)
      squares += std::pow(meansA[i] - meansB[i], 2) / (2 * pairs * 3 * blocks);
    said += BlockError(a, geometry, CameraRays(scene.camera, edge, edge), edge, edge).ofPicture() /
            pairs;
  }
  EXPECT_NEAR(said / std::sqrt(squares), 1, 0.1);
}

// More particles could not make it more precise.
TEST(PathTest, DarknessIsKnownAtOnce) {
  Scene scene = sceneOf(bodyOf(test::sphere({0, 0, 0}, 4, 2), 1, 0.02, 1.3));
  scene.camera.positionMm = {0, 0, 30};
  scene.lighting.directional = {{{0, 0, 1}, {0, 0, 0}}};
  const Geometry geometry(scene);
  PathTracer tracer(geometry, {});
  const BlockError error(tracer, geometry, CameraRays(scene.camera, 16, 16), 16, 16);
  for (const PathLimits& limits : {PathLimits{{}, {}, 0.02}, PathLimits{{}, 1e6, {}},
                                   PathLimits{1'000'000'000'000U, {}, {}}}) {
    EXPECT_EQ(runPaths(tracer, error, limits), 0);
  }
  EXPECT_EQ(tracer.particles(), 0U);
}

TEST(PathTest, StrongForwardScatteringMeansTheSameReducedScattering) {
  // Similarity (van de Hulst 1980): far from where light enters only σ_s' matters. It is not exact,
  // but the flux that leaves agrees to a few per cent.
  Scene scene = sceneOf(bodyOf(test::sphere({0, 0, 0}, 8, 4), 1, 0.01, 1.3));
  scene.lighting.ambient = {1, 1, 1};
  Scene forwardScene = scene;
  forwardScene.bodies[0].medium.g = 0.8;
  const Geometry geometry(scene);
  const Geometry sameGeometry(forwardScene);
  PathTracer isotropic(geometry, {});
  PathTracer forward(sameGeometry, {});
  isotropic.run(12000);
  forward.run(12000);
  EXPECT_NEAR(allFlux(forward) / allFlux(isotropic), 1, 0.04);
}

TEST(CellsTest, AreasAddUpAndPointsFindTheirCell) {
  const Scene scene = sceneOf(bodyOf(test::box({0, 0, 0}, {5, 4, 3}, 2), 1, 0.1, 1.3));
  const Geometry geometry(scene);
  const Cells cells(scene, 0.5, Cells::Of::Media);
  double sum = 0;
  for (std::size_t i = 0; i < cells.count(); ++i) sum += cells.areaMm2(i);
  EXPECT_NEAR(sum, 8 * (5 * 4 + 4 * 3 + 3 * 5), 1e-6);
  // Places that are uniform on the surface fall into cells by their areas.
  std::vector<double> areaSoFar;
  for (const Triangle& t : scene.bodies[0].triangles) {
    const std::vector<Vector>& p = scene.bodies[0].positionsMm;
    areaSoFar.push_back((areaSoFar.empty() ? 0 : areaSoFar.back()) +
                        0.5 * length(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]])));
  }
  std::vector<double> found(cells.count());
  Random random(3, 0);
  constexpr int places = 400000;
  for (int i = 0; i < places; ++i) {
    const auto triangle = static_cast<std::uint32_t>(
        std::upper_bound(areaSoFar.begin(), areaSoFar.end(), random() * areaSoFar.back()) -
        areaSoFar.begin());
    const double root = std::sqrt(random());
    const double v = random();
    found[cells.at(geometry.pointOn(0, triangle, {1 - root, root * (1 - v), root * v}))] += 1;
  }
  for (std::size_t i = 0; i < cells.count(); ++i) {
    const double expected = places * cells.areaMm2(i) / sum;
    EXPECT_NEAR(found[i], expected, 6 * std::sqrt(expected)) << i;
  }
}

}  // namespace
}  // namespace opaline::reference
