// Area lights: their light on a plate against closed forms and quadrature, and their penumbrae.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "renderer/area_light_truth.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;

using std::numbers::pi;

using AreaLightTest = RendererTest;

Medium ofIndex(double eta) {
  Medium medium = marble();
  medium.eta = eta;
  return medium;
}

// The plate y = 0, from above.
Scene plate(const Medium& medium, float halfMm = 20, int cells = 64) {
  return sceneOf(sheet({0, 0, 0}, {0, 0, halfMm}, {halfMm, 0, 0}, cells), medium, {0, 90, 1},
                 0.9F * halfMm);
}

// Shows the surfels that the camera sees.
RenderOptions options() {
  RenderOptions options = smallOptions();
  options.maxSurfels = 65'536;
  options.width = options.height = 32;
  return options;
}

struct Found {
  Vector position;
  double irradiance;
};

std::vector<Found> irradianceOf(const std::vector<Image>& images) {
  std::vector<Found> found;
  forEachCovered(images[0], [&](std::size_t i) {
    found.push_back({toVector(&images[0].rgba[i]), static_cast<double>(images[1].rgba[i])});
  });
  return found;
}

// With an index near 1 all light enters, so Lambert's closed forms hold on the axis.
TEST_F(AreaLightTest, HaveTheirClosedForms) {
  constexpr double eta = 1.01;
  constexpr double height = 10;
  const auto rectangle = [](double a, double b) {  // of a corner above the point
    const double x = a / height;
    const double y = b / height;
    const double p = std::sqrt(1 + x * x);
    const double q = std::sqrt(1 + y * y);
    return 0.5 * (x / p * std::atan(y / p) + y / q * std::atan(x / q));
  };
  const auto sphere = [](const Vector& centre) {  // wholly above the horizon
    return [centre](const Vector& position) {
      const Vector offset = centre - position;
      return 2 * pi * 36 * offset[1] / std::pow(length(offset), 3);
    };
  };
  struct Case {
    AreaLight light;
    std::function<double(const Vector&)> expected;
  };
  const std::vector<Case> cases{{RectangleLight{{0, 10, 0}, {6, 0, 0}, {0, 0, 9}, {2, 2, 2}},
                                 [&](const Vector&) { return 2 * 4 * rectangle(6, 9); }},
                                {DiscLight{{0, 10, 0}, {0, -1, 0}, 8, {2, 2, 2}},
                                 [](const Vector&) { return 2 * pi * 64 / (64 + 100); }},
                                {SphereLight{{0, 10, 0}, 6, {2, 2, 2}}, sphere({0, 10, 0})},
                                {SphereLight{{6, 8, 0}, 6, {2, 2, 2}}, sphere({6, 8, 0})}};
  for (const Case& each : cases) {
    Scene scene = plate(ofIndex(eta), 1, 8);
    scene.lighting.areas = {each.light};
    double sum = 0;
    double sumExpected = 0;
    for (const Found& found :
         irradianceOf(render(scene, options(), {Aov::Position, Aov::Irradiance})))
      if (length(found.position) < 0.3) {
        sum += found.irradiance;
        sumExpected += each.expected(found.position);
      }
    ASSERT_GT(sumExpected, 0);
    EXPECT_NEAR(sum / sumExpected, 1, 0.01) << each.light.index();
  }
}

TEST_F(AreaLightTest, GiveAPlateWhatQuadratureGives) {
  for (const double eta : {1.3, 1.5})
    for (const AreaLight& light : everyShape()) {
      Scene scene = plate(ofIndex(eta));
      scene.lighting.areas = {light};
      std::vector<std::pair<double, double>> values;
      double most = 0;
      double sum = 0;
      double sumExpected = 0;
      int number = 0;
      for (const Found& found :
           irradianceOf(render(scene, options(), {Aov::Position, Aov::Irradiance}))) {
        if (++number % 13 != 0) continue;
        const double expected = byQuadrature(light, found.position, eta);
        most = std::max(most, expected);
        sum += found.irradiance;
        sumExpected += expected;
        values.emplace_back(found.irradiance, expected);
      }
      std::vector<double> errors;
      for (const auto& [value, expected] : values)
        if (expected > 0.02 * most) errors.push_back(std::abs(value / expected - 1));
      EXPECT_LT(percentile95(errors), 0.03) << eta << ", shape " << light.index();
      EXPECT_NEAR(sum / sumExpected, 1, 0.01) << eta << ", shape " << light.index();
    }
}

TEST_F(AreaLightTest, ASmallOneIsAPointLight) {
  Scene scene = plate(ofIndex(1.4));
  const float area = 4 * 0.2F * 0.2F;
  // A light that faces straight down has the intensity L A μ.
  scene.lighting.areas = {RectangleLight{{0, 20, 0}, {0.2F, 0, 0}, {0, 0, 0.2F}, {100, 100, 100}}};
  const auto square = irradianceOf(render(scene, options(), {Aov::Position, Aov::Irradiance}));
  scene.lighting = {};
  scene.lighting.points = {{{0, 20, 0}, {100 * area, 100 * area, 100 * area}}};
  const auto point = irradianceOf(render(scene, options(), {Aov::Position, Aov::Irradiance}));
  ASSERT_EQ(square.size(), point.size());
  for (std::size_t i = 0; i < square.size(); ++i) {
    const Vector offset = Vector{0, 20, 0} - point[i].position;
    const double cosine = unit(offset)[1];
    ASSERT_NEAR(square[i].irradiance / (point[i].irradiance * cosine), 1, 0.006);
  }
}

// A plate, and a sheet that hides the part of a disc left of `edge`, as seen from the middle.
Scene plateBelowHalfPlane(float radius, float edge) {
  Scene scene = plate(ofIndex(1.4), 12, 96);
  scene.objects.push_back(
      {"half plane", sheet({edge / 2 - 6, 50, 0}, {0, 0, 12}, {6, 0, 0}, 2), marble()});
  scene.camera.positionMm = {0, 40, 1};
  scene.camera.verticalFovDegrees = 25;
  scene.lighting.areas = {DiscLight{{0, 100, 0}, {0, -1, 0}, radius, {500, 500, 500}}};
  return scene;
}

// The sheet hides half of the plane below a distant disc, so a segment of the disc remains visible.
TEST_F(AreaLightTest, TheirPenumbraIsTheAreaOfASegment) {
  constexpr double radius = 4;
  const Scene scene = plateBelowHalfPlane(radius, 0);
  std::vector<double> errors;
  // Sums over all surfels at one distance from the edge.
  constexpr int columns = 20;
  std::array<double, columns> sum{};
  std::array<int, columns> count{};
  for (const Found& found :
       irradianceOf(render(scene, options(), {Aov::Position, Aov::Irradiance}))) {
    const double x = found.position[0];
    if (std::abs(found.position[1]) > 1e-3 || std::abs(x) > 6) continue;
    const double open = byQuadrature(scene.lighting.areas[0], found.position, 1.4);
    // Seen from x, the edge at the height 50 hides the part of the disc left of -x.
    const double error = found.irradiance / open - shareBeyondEdge(-x, radius);
    errors.push_back(std::abs(error));
    const auto column = static_cast<std::size_t>((x + 6) / 12 * columns) % columns;
    sum[column] += error;
    ++count[column];
  }
  ASSERT_GT(errors.size(), 500U);
  EXPECT_LT(percentile95(errors), 0.065);  // single surfels
  for (std::size_t i = 0; i < columns; ++i) EXPECT_LT(std::abs(sum[i] / count[i]), 0.025) << i;
}

// The penumbra is a fifth of a surfel wide: neighbouring surfels are not mixed.
TEST_F(AreaLightTest, TheShadowOfASmallOneIsSharp) {
  constexpr float edge = 0.18F;  // within adjacent surfels
  const Scene scene = plateBelowHalfPlane(0.0125F, edge);
  int lit = 0;
  int dark = 0;
  for (const Found& found :
       irradianceOf(render(scene, options(), {Aov::Position, Aov::Irradiance}))) {
    const double x = found.position[0] - double{edge};
    constexpr double surfel = 0.125;
    if (std::abs(found.position[1]) > 1e-3 || std::abs(x) < 1.5 * surfel || std::abs(x) > 1)
      continue;
    const double open = byQuadrature(scene.lighting.areas[0], found.position, 1.4);
    EXPECT_NEAR(found.irradiance / open, x > 0 ? 1 : 0, 0.01) << x;
    ++(x > 0 ? lit : dark);
  }
  EXPECT_GT(lit, 20);
  EXPECT_GT(dark, 20);
}

TEST_F(AreaLightTest, ShineToTheirFrontUnlessTheyHaveTwoSides) {
  Scene scene = plate(ofIndex(1.4));
  RectangleLight light{{0, 10, 0}, {0, 0, 5}, {5, 0, 0}, {1, 1, 1}};  // faces upwards
  scene.lighting.areas = {light};
  for (const Found& found :
       irradianceOf(render(scene, options(), {Aov::Position, Aov::Irradiance})))
    ASSERT_EQ(found.irradiance, 0);
  light.twoSided = true;
  scene.lighting.areas = {light};
  for (const Found& found :
       irradianceOf(render(scene, options(), {Aov::Position, Aov::Irradiance})))
    ASSERT_GT(found.irradiance, 0);
}

// A smooth surface mirrors a light in its shape, with the light's radiance times Fresnel's
// reflectance. That is (0.5 / 2.5)² along the normal.
TEST_F(AreaLightTest, AreMirroredWithTheirShape) {
  Scene scene = plate(ofIndex(1.5), 20, 8);
  // Its mirror image is 10 mm behind the plate: from 90 mm above, the edge at x = 6 is seen at 5.4.
  scene.lighting.areas = {RectangleLight{{0, 10, 0}, {6, 0, 0}, {0, 0, 6}, {2, 2, 2}}};
  RenderOptions mirror = options();
  mirror.width = mirror.height = 96;
  mirror.roughness = 0.05F;
  const auto with = render(scene, mirror, {Aov::Position, Aov::Radiance});
  mirror.specular = false;
  const Image without = render(scene, mirror, {Aov::Radiance})[0];
  int inside = 0;
  int outside = 0;
  forEachCovered(with[0], [&](std::size_t i) {
    const double x = std::abs(static_cast<double>(with[0].rgba[i]));
    const double z = std::abs(static_cast<double>(with[0].rgba[i + 2]));
    const double mirrored =
        static_cast<double>(with[1].rgba[i]) - static_cast<double>(without.rgba[i]);
    if (std::max(x, z) < 4.6) {
      ++inside;
      ASSERT_NEAR(mirrored, 2 * 0.04, 0.004) << x << ' ' << z;
    } else if (std::max(x, z) > 6.6) {
      ++outside;
      ASSERT_LT(mirrored, 0.004) << x << ' ' << z;
    }
  });
  EXPECT_GT(inside, 200);
  EXPECT_GT(outside, 2000);
}

// A surface mirrors a very small light as it mirrors a point.
TEST_F(AreaLightTest, ASmallOneIsMirroredAsAPointIs) {
  Scene scene = sceneOf(sphere({0, 0, 0}, 5, 4), marble(), {0, 0, 30}, 5.5F);
  const Vec3 place{20, 30, 40};
  constexpr double intensity = 4000;
  RenderOptions look = options();
  look.width = look.height = 96;
  const auto mirrored = [&] {
    look.specular = true;
    const Image with = render(scene, look, {Aov::Radiance})[0];
    look.specular = false;
    const Image without = render(scene, look, {Aov::Radiance})[0];
    double sum = 0;
    forEachCovered(with, [&](std::size_t i) {
      sum += static_cast<double>(with.rgba[i]) - static_cast<double>(without.rgba[i]);
    });
    return sum;
  };
  scene.lighting.points = {{place, {4000, 4000, 4000}}};
  const double ofPoint = mirrored();
  scene.lighting.points.clear();
  for (const double radiusMm : {1.0, 0.1, 0.01}) {
    const auto radiance = static_cast<float>(intensity / (pi * radiusMm * radiusMm));
    scene.lighting.areas = {
        SphereLight{place, static_cast<float>(radiusMm), {radiance, radiance, radiance}}};
    EXPECT_NEAR(mirrored() / ofPoint, 1, 0.04) << radiusMm;
  }
}

// The same solver must treat light that enters the body with and without area lights.
TEST_F(AreaLightTest, ABodyTakesThemAsItTakesManyPointLights) {
  Scene scene = sceneOf(sphere({0, 0, 0}, 5, 4), marble(), {0, 0, 30}, 5.5F);
  const RectangleLight light{{0, 28, 18}, {10, 0, 0}, {0, -5, 8}, {4, 4, 4}};
  RenderOptions boundary = options();
  boundary.transport = Transport::Boundary;
  boundary.sum = Sum::Tree;
  scene.lighting.areas = {light};
  const Image area = render(scene, boundary, {Aov::Exitance})[0];
  scene.lighting = {};
  constexpr int across = 2;  // limited by the number of shadow maps for point lights
  std::vector<float> sum(area.rgba.size(), 0);
  constexpr int steps = 5;
  for (int i = 0; i < steps * steps; i += across * across) {
    scene.lighting.points.clear();
    for (int k = i; k < std::min(i + across * across, steps * steps); ++k) {
      const int row = k / steps;
      const AreaPoint place = pointOn(light, (k % steps + 0.5) / steps, (row + 0.5) / steps);
      const Vector toBody = -1.0 * Vector(place.positionMm);
      const double facing = dot(unit(toBody), Vector(place.normal));
      const auto power = static_cast<float>(4 * facing * areaMm2(light) / (steps * steps));
      scene.lighting.points.push_back({toVec3(Vector(place.positionMm)), {power, power, power}});
    }
    const Image part = render(scene, boundary, {Aov::Exitance})[0];
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += part.rgba[k];
  }
  double error = 0;
  double all = 0;
  forEachCovered(area, [&](std::size_t i) {
    const double difference = static_cast<double>(area.rgba[i]) - static_cast<double>(sum[i]);
    error += difference * difference;
    all += static_cast<double>(sum[i]) * static_cast<double>(sum[i]);
  });
  EXPECT_LT(std::sqrt(error / all), 0.03);
}

double rmsOverMean(const Image& image, const std::vector<float>& expected) {
  double squares = 0;
  double mean = 0;
  const int count = forEachCovered(image, [&](std::size_t i) {
    for (std::size_t c = 0; c < 3; ++c) {
      squares += std::pow(double{image.rgba[i + c]} - double{expected[i + c]}, 2) / 3;
      mean += double{expected[i + c]} / 3;
    }
  });
  return std::sqrt(squares * count) / mean;
}

// Its slanting light collides nearer to the surface than light from its middle would, and so must
// equal that of many small lights.
TEST_F(AreaLightTest, ALargeOneNearABodyIsManySmallOnes) {
  constexpr int across = 8;
  constexpr float halfMm = 10;
  constexpr float partMm = halfMm / across;
  RenderOptions boundary = options();
  boundary.transport = Transport::Boundary;
  boundary.maxSurfels = 4096;
  for (const Medium& medium : {marble(), skin()}) {
    Scene scene = sceneOf(sphere({0, 0, 0}, 5, 4), medium, {12, 6, 24}, 5.5F);
    scene.lighting.areas = {RectangleLight{{0, 9, 0}, {halfMm, 0, 0}, {0, 0, halfMm}, {4, 4, 4}}};
    const Image whole = render(scene, boundary, {Aov::Exitance})[0];
    std::vector<float> sum(whole.rgba.size(), 0);
    for (int first = 0; first < across * across; first += static_cast<int>(Lighting::maxLights)) {
      scene.lighting.areas.clear();
      for (int k = first; k < first + static_cast<int>(Lighting::maxLights); ++k) {
        const auto place = [&](int i) { return partMm * static_cast<float>(2 * i + 1) - halfMm; };
        scene.lighting.areas.emplace_back(RectangleLight{
            {place(k % across), 9, place(k / across)}, {partMm, 0, 0}, {0, 0, partMm}, {4, 4, 4}});
      }
      const Image part = render(scene, boundary, {Aov::Exitance})[0];
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += part.rgba[k];
    }
    EXPECT_LT(rmsOverMean(whole, sum), 0.055) << medium.name;
  }
}

TEST_F(AreaLightTest, ThePatternRefusesThem) {
  Scene scene = plate(marble());
  scene.lighting.areas = {DiscLight{}};
  RenderOptions pattern = options();
  pattern.sum = Sum::Pattern;
  EXPECT_THROW(render(scene, pattern, {Aov::Irradiance}), UsageError);
}

}  // namespace
}  // namespace opaline
