// Gathering and scattering use the deformed surface: its areas, positions, shadow maps and near
// plane.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bssrdf/fresnel.h"
#include "bssrdf/profile.h"
#include "deform/deformed_vertices.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;

using DeformedTest = RendererTest;

using Colour = std::array<double, 3>;

/// ∫ R_d(|x − place|) dA over triangles. Points are weighted as their triangle's area says.
class SurfaceIntegral {
 public:
  explicit SurfaceIntegral(const Medium& medium) {
    for (int c = 0; c < 3; ++c) {
      profiles_.push_back(
          bssrdf::makeProfile(bssrdf::Model::Dipole, bssrdf::coefficients(medium, c)));
      depth_ = std::min(depth_, profiles_.back().zRealMm);
    }
  }

  Colour over(const Mesh& mesh, const std::vector<Vector>& positions,
              const std::vector<Vector>& areas, const Vector& place) const {
    Colour sum{};
    for (const Triangle& t : mesh.triangles) {
      const double moved = area(positions[t[0]], positions[t[1]], positions[t[2]]);
      const double counted = area(areas[t[0]], areas[t[1]], areas[t[2]]);
      Colour part{};
      add({positions[t[0]], positions[t[1]], positions[t[2]]}, place, moved, part);
      for (std::size_t c = 0; c < 3; ++c) sum[c] += part[c] * counted / moved;
    }
    return sum;
  }

 private:
  using Corners = std::array<Vector, 3>;

  static double area(const Vector& a, const Vector& b, const Vector& c) {
    const Vector u = b - a;
    const Vector v = c - a;
    return 0.5 * length({u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                         u[0] * v[1] - u[1] * v[0]});
  }

  // The midpoint rule on pieces that are small compared to their distance and the profile's depth.
  void add(const Corners& t, const Vector& place, double areaMm2, Colour& sum) const {
    const Vector middle = (1.0 / 3) * (t[0] + t[1] + t[2]);
    const double distance = length(middle - place);
    const double edge = std::max({length(t[1] - t[0]), length(t[2] - t[1]), length(t[0] - t[2])});
    if (edge <= 0.25 * std::hypot(distance, depth_)) {
      for (std::size_t c = 0; c < 3; ++c) sum[c] += areaMm2 * profiles_[c](distance);
      return;
    }
    const Corners m{0.5 * (t[0] + t[1]), 0.5 * (t[1] + t[2]), 0.5 * (t[2] + t[0])};
    for (const Corners& piece : {Corners{t[0], m[0], m[2]}, Corners{m[0], t[1], m[1]},
                                 Corners{m[2], m[1], t[2]}, Corners{m[0], m[1], m[2]}})
      add(piece, place, areaMm2 / 4, sum);
  }

  std::vector<bssrdf::Profile> profiles_;
  double depth_ = 1e9;
};

struct Errors {
  double largest = 0;
  int pixels = 0;
};

/// Largest relative deviation of B from E · ∫ R_d dA over the pixels.
Errors compareWithIntegral(const Scene& scene, const std::vector<Image>& images,
                           const std::vector<Vector>& positions, const std::vector<Vector>& areas) {
  const Object& object = scene.objects[0];
  const SurfaceIntegral integral(object.medium);
  const double entered = std::numbers::pi * bssrdf::meanTransmittance(object.medium.eta);
  Errors errors;
  errors.pixels = forEachCovered(images[0], [&](std::size_t i) {
    const Colour exact = integral.over(object.mesh, positions, areas, toVector(&images[1].rgba[i]));
    for (std::size_t c = 0; c < 3; ++c) {
      const double found = static_cast<double>(images[0].rgba[i + c]);
      errors.largest = std::max(errors.largest, std::abs(found / (entered * exact[c]) - 1));
    }
  });
  return errors;
}

std::vector<Vector> deformedPositions(const Scene& scene) {
  std::vector<Vector> positions;
  for (const scene::Double3& p : deform::deformedVertices(scene, 0, -1, 0).positionsMm)
    positions.push_back(p);
  return positions;
}

std::vector<Vector> restPositions(const Scene& scene) {
  std::vector<Vector> positions;
  for (const Vec3& p : scene.objects[0].mesh.positionsMm) positions.push_back(toVector(p));
  return positions;
}

/// In uniform light E is the same everywhere, so B is E times the integral of the profile.
void expectIntegral(Scene scene, const std::vector<Deformer>& deformers, int edge) {
  scene.deformers = deformers;
  scene.lighting = {};
  scene.lighting.ambient = {1, 1, 1};
  RenderOptions options = finelyDivided(smallOptions());
  options.dsmSize = 512;
  options.width = options.height = edge;
  options.sum = Sum::All;
  options.site = Site::Fragment;
  sharedRenderer().renderer->setScene(scene);
  sharedRenderer().renderer->setTime({.clip = -1});
  const std::vector<Image> images =
      sharedRenderer().renderer->render(options, {Aov::Exitance, Aov::Position}).images;
  const std::vector<Vector> moved = deformedPositions(scene);
  const Errors errors = compareWithIntegral(scene, images, moved, moved);
  EXPECT_GT(errors.pixels, edge * edge / 8);
  EXPECT_LT(errors.largest, 0.01);
  // With the areas of the rest pose, the result is clearly different.
  EXPECT_GT(compareWithIntegral(scene, images, moved, restPositions(scene)).largest, 0.05);
}

Scene smallBall() {
  return sceneOf(sphere({0, 0, 0}, 5, 4), marble(), {8, 12, 20}, 6);
}

TEST_F(DeformedTest, SquashedSphereHasTheExactIntegral) {
  expectIntegral(smallBall(), {{DeformerKind::Squash, 0.5F, 0}}, 12);
}

TEST_F(DeformedTest, StretchedAndBentSphereHasTheExactIntegral) {
  expectIntegral(smallBall(), {{DeformerKind::Squash, -0.6F, 0}, {DeformerKind::Bend, 1.2F, 0}},
                 12);
}

TEST_F(DeformedTest, TwistedBearHasTheExactIntegral) {
  LoadOptions load;
  load.diagonalMm = 16;
  load.medium = marble();
  expectIntegral(builtInBear(load), {{DeformerKind::Twist, 2.5F, 0}}, 10);
}

// ---- changes that must not matter

struct Rigid {
  std::array<Vector, 3> rows;
  Vector shift;

  Vec3 direction(const Vec3& v) const {
    const Vector from = toVector(v);
    return toVec3({dot(rows[0], from), dot(rows[1], from), dot(rows[2], from)});
  }
  Vec3 point(const Vec3& p) const { return toVec3(toVector(direction(p)) + shift); }
};

/// A rotation by 0.9 about (1, 2, 3), Rodrigues 1840, and a shift.
Rigid someMotion() {
  const Vector k = unit({1, 2, 3});
  const double c = std::cos(0.9);
  const double s = std::sin(0.9);
  const double o = 1 - c;
  return {{Vector{c + k[0] * k[0] * o, k[0] * k[1] * o - k[2] * s, k[0] * k[2] * o + k[1] * s},
           Vector{k[1] * k[0] * o + k[2] * s, c + k[1] * k[1] * o, k[1] * k[2] * o - k[0] * s},
           Vector{k[2] * k[0] * o - k[1] * s, k[2] * k[1] * o + k[0] * s, c + k[2] * k[2] * o}},
          {30, -70, 45}};
}

void moveAround(const Rigid& motion, Scene& scene) {
  for (DirectionalLight& light : scene.lighting.directional)
    light.directionToLight = motion.direction(light.directionToLight);
  for (PointLight& light : scene.lighting.points) light.positionMm = motion.point(light.positionMm);
  scene.camera.positionMm = motion.point(scene.camera.positionMm);
  scene.camera.targetMm = motion.point(scene.camera.targetMm);
  scene.camera.up = motion.direction(scene.camera.up);
}

double relativeRms(const Image& a, const Image& b) {
  double squares = 0;
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    if (i % 4 == 3) continue;
    const auto value = static_cast<double>(b.rgba[i]);
    squares += std::pow(static_cast<double>(a.rgba[i]) - value, 2);
    sum += value;
  }
  const double count = static_cast<double>(a.rgba.size()) * 0.75;
  return std::sqrt(squares / count) / (sum / count);
}

/// Two intersecting balls that cast shadows on each other and themselves.
Scene litSnowman() {
  Scene scene = sceneOf(together(sphere({0, -6, 0}, 14, 4), sphere({4, 14, 5}, 9, 4)), marble(),
                        {20, 15, 90}, 26);
  scene.lighting.directional = {{{0.45F, 0.35F, -0.82F}, {3, 3, 3}},
                                {{-0.6F, 0.3F, 0.7F}, {1, 1, 1}}};
  scene.lighting.points = {{{40, 30, 10}, {2000, 1500, 1000}}};
  scene.lighting.ambient = {0.1F, 0.1F, 0.1F};
  return scene;
}

RenderOptions pictureOptions() {
  RenderOptions options = smallOptions();
  options.width = options.height = 128;
  options.antialias = 4;
  options.shadowSize = 1024;
  options.dsmSize = 512;
  return options;
}

/// The snowman, its positions, lights and camera moved rigidly.
Image carried(const Rigid& motion, const RenderOptions& options) {
  Scene scene = litSnowman();
  moveAround(motion, scene);
  std::vector<Vec3> moved;
  for (const Vec3& p : scene.objects[0].mesh.positionsMm) moved.push_back(motion.point(p));
  Renderer& renderer = *sharedRenderer().renderer;
  renderer.setScene(scene);
  renderer.replacePositions(0, moved);
  return renderer.render(options, {Aov::Radiance}).images[0];
}

const Rigid noMotion{{Vector{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

TEST_F(DeformedTest, RigidMotionChangesNothing) {
  RenderOptions options = finelyDivided(pictureOptions());
  options.specular = false;
  EXPECT_LT(relativeRms(carried(someMotion(), options), carried(noMotion, options)), 1e-3);
}

// At grazing light, texels of the shadow map decide whether a highlight is lit, and a rotation
// moves them. Only a few pixels may change.
TEST_F(DeformedTest, RigidMotionLeavesHighlightsButAtTheTerminator) {
  const RenderOptions options = pictureOptions();
  const Image still = carried(noMotion, options);
  const Image moved = carried(someMotion(), options);
  int different = 0;
  const int covered = forEachCovered(still, [&](std::size_t i) {
    different += std::abs(moved.rgba[i + 1] - still.rgba[i + 1]) > 0.01F ? 1 : 0;
  });
  EXPECT_LT(different, covered / 50);
}

// A power of two, so that meshes scale exactly and get the same atlas.
TEST_F(DeformedTest, OnlySizeInMeanFreePathsMatters) {
  constexpr float factor = 8;
  Scene scene = litSnowman();
  const Image small = render(scene, pictureOptions(), {Aov::Radiance})[0];
  for (Vec3& p : scene.objects[0].mesh.positionsMm)
    for (float& x : p) x *= factor;
  for (double& sigma : scene.objects[0].medium.sigmaSPrimePerMm)
    sigma /= static_cast<double>(factor);
  for (double& sigma : scene.objects[0].medium.sigmaAPerMm) sigma /= static_cast<double>(factor);
  for (PointLight& light : scene.lighting.points) {
    for (float& x : light.positionMm) x *= factor;
    for (float& power : light.intensity) power *= factor * factor;
  }
  for (float& x : scene.camera.positionMm) x *= factor;
  for (float& x : scene.camera.targetMm) x *= factor;
  const Image large = render(scene, pictureOptions(), {Aov::Radiance})[0];
  EXPECT_LT(relativeRms(large, small), 1e-3);
}

// ---- frames under way

TEST_F(DeformedTest, FramesUnderWayAreThoseRenderedAlone) {
  Scene scene = litSnowman();
  scene.deformers = {{DeformerKind::Wobble, 0.05F, 1}, {DeformerKind::Twist, 0.5F, 2}};
  renderer().setScene(scene);
  RenderOptions options = smallOptions();
  const std::vector<Aov> aovs{Aov::Radiance, Aov::Exitance, Aov::DsmArea};
  std::vector<std::vector<Image>> alone;
  for (int i = 0; i < 5; ++i) alone.push_back(renderAt(0.15 * i, options, aovs));
  View view(renderer(), options);
  Frame frame;
  for (int i = 0; i < 6; ++i) {
    renderer().setTime({.seconds = 0.15 * i});
    if (i < 5) view.submit({.aovs = aovs});
    if (i == 0) continue;
    view.collect(frame);
    for (std::size_t k = 0; k < aovs.size(); ++k)
      EXPECT_TRUE(frame.images[k].rgba == alone[static_cast<std::size_t>(i - 1)][k].rgba)
          << "frame " << i - 1 << ", variable " << k;
  }
  EXPECT_FALSE(alone[0][0].rgba == alone[3][0].rgba);
  EXPECT_THROW(view.collect(frame), UsageError);
  EXPECT_GT(view.report().passes.size(), 5U);
}

TEST_F(DeformedTest, NoMoreFramesThanMayBeUnderWay) {
  renderer().setScene(litSnowman());
  View view(renderer(), smallOptions());
  for (int i = 0; i < View::framesInFlight; ++i) view.submit();
  EXPECT_THROW(view.submit(), UsageError);
  EXPECT_THROW(view.render(), UsageError);
  Frame frame;
  for (int i = 0; i < View::framesInFlight; ++i) view.collect(frame);
  EXPECT_NO_THROW(view.render());
}

TEST_F(DeformedTest, PositionsGivenWhileFramesAreUnderWayAreTheNextFrames) {
  const Scene scene = litSnowman();
  renderer().setScene(scene);
  const std::vector<Vec3>& rest = scene.objects[0].mesh.positionsMm;
  const auto shifted = [&](int frame) {
    std::vector<Vec3> positions = rest;
    for (Vec3& p : positions) p[1] += 2 * static_cast<float>(frame);
    return positions;
  };
  const auto meanHeight = [](const Image& position) {
    double sum = 0;
    const int count = forEachCovered(
        position, [&](std::size_t i) { sum += static_cast<double>(position.rgba[i + 1]); });
    return sum / count;
  };
  renderer().setTime({.clip = -1});
  View view(renderer(), smallOptions());
  Frame frame;
  double first = 0;
  for (int i = 0; i < 7; ++i) {
    if (i < 6) {
      renderer().replacePositions(0, shifted(i));
      view.submit({.aovs = {Aov::DsmPosition}});
    }
    if (i == 0) continue;
    view.collect(frame);
    const double mean = meanHeight(frame.images[0]);
    if (i == 1) first = mean;
    EXPECT_NEAR(mean - first, 2 * (i - 1), 1e-3);
  }
}

TEST_F(DeformedTest, GivenPositionsSurviveAnotherMapSize) {
  const Scene scene = litSnowman();
  renderer().setScene(scene);
  std::vector<Vec3> positions = scene.objects[0].mesh.positionsMm;
  for (Vec3& p : positions) p[1] += 100;
  renderer().replacePositions(0, positions);
  RenderOptions options = smallOptions();
  for (const int size : {128, 256}) {
    options.dsmSize = size;
    const Image position = render(options, {Aov::DsmPosition})[0];
    EXPECT_GT(forEachCovered(position, [&](std::size_t i) { EXPECT_GT(position.rgba[i + 1], 70); }),
              0);
  }
}

TEST_F(DeformedTest, ARendererMayGoWithFramesUnderWay) {
  Renderer fresh(sharedRenderer().options());
  fresh.setScene(litSnowman());
  View view(fresh, smallOptions());
  for (int i = 0; i < View::framesInFlight; ++i) view.submit();
}

}  // namespace
}  // namespace opaline
