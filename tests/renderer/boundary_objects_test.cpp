// Boundary transport with several objects: light that leaves one enters another, by the angle under
// which they see each other, unless a third is in between.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "bssrdf/fresnel.h"
#include "renderer/boundary_fixture.h"

namespace opaline {
namespace {

using namespace test;

using BoundaryObjectsTest = RendererTest;

Medium milky() {
  return {"milky", {6, 6, 6}, {1e-4, 1e-4, 1e-4}, 1.3};
}
/// Skin1 in red, 27 times denser: light does not get far from where it enters.
Medium dense() {
  return {"dense", {20, 20, 20}, {0.8649, 0.8649, 0.8649}, 1.3};
}
Medium black() {
  return {"black", {0.01, 0.01, 0.01}, {50, 50, 50}, 1.3};
}

constexpr double milkyRadiusMm = 5;
constexpr double denseRadiusMm = 3;

/// A milky ball at the origin in light from +z, and a dense one in the shade of a black roof.
Scene ballBesideAnother(const Vector& denseCentre, const std::optional<Mesh>& wall = std::nullopt) {
  Scene scene =
      sceneOf(sphere({0, 0, 0}, static_cast<float>(milkyRadiusMm), 4), milky(), {0, -80, 0}, 17);
  scene.camera.up = {0, 0, 1};
  scene.objects.push_back(
      {"dense", sphere(toVec3(denseCentre), static_cast<float>(denseRadiusMm), 4), dense()});
  scene.objects.push_back(
      {"roof", box(toVec3({denseCentre[0], denseCentre[1], 14}), {4, 4, 0.5F}, 4), black()});
  if (wall) scene.objects.push_back({"wall", *wall, black()});
  scene.lighting.directional = {{{0, 0, 1}, {1, 1, 1}}};
  return scene;
}

struct Seen {
  Image exitance;
  Image position;
  Image object;
};

Seen seen(const Scene& scene, int bounces, int edge = 96) {
  std::vector<Image> images = renderBoundary(scene, boundaryOptions(edge, bounces),
                                             {Aov::Exitance, Aov::Position, Aov::Object})
                                  .images;
  return {std::move(images[0]), std::move(images[1]), std::move(images[2])};
}

template <typename Check>
void forEachOf(const Seen& picture, float object, const Check& check) {
  forEachCovered(picture.object, [&](std::size_t i) {
    if (picture.object.rgba[i] == object)
      check(toVector(&picture.position.rgba[i]), static_cast<double>(picture.exitance.rgba[i + 1]));
  });
}

/// Mean exitance of the milky ball by the cosine to the light, on which alone it depends.
class ExitanceByCosine {
 public:
  explicit ExitanceByCosine(const Seen& picture) {
    std::array<int, bands> count{};
    forEachOf(picture, 0, [&](const Vector& at, double exitance) {
      const std::size_t band = bandOf(at);
      mean_[band] += exitance;
      ++count[band];
    });
    for (std::size_t band = 0; band < bands; ++band) {
      EXPECT_GT(count[band], 0);
      mean_[band] /= std::max(count[band], 1);
    }
  }
  double at(const Vector& place) const { return mean_[bandOf(place)]; }

 private:
  static constexpr std::size_t bands = 20;
  static std::size_t bandOf(const Vector& at) {
    return static_cast<std::size_t>(
        std::clamp((at[2] / length(at) + 1) / 2 * static_cast<double>(bands), 0.0, bands - 0.5));
  }
  std::array<double, bands> mean_{};
};

double transmittance(double cosine) {
  return 1 - bssrdf::fresnelReflectance(1.3, cosine);
}

/// Light of the milky ball that enters at a place: radiance M F_t / (π F̄_t) over the visible part.
double enteringAt(const Vector& place, const Vector& normal, const ExitanceByCosine& exitance) {
  constexpr int steps = 30;
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < 2 * steps; ++k) {
      const double z = (i + 0.5) / steps * 2 - 1;
      const double angle = std::numbers::pi * (k + 0.5) / steps;
      const double across = std::sqrt(1 - z * z);
      const Vector outward{across * std::cos(angle), across * std::sin(angle), z};
      const Vector from = milkyRadiusMm * outward;
      const Vector way = place - from;
      const double leaving = dot(way, outward) / length(way);
      const double arriving = -dot(way, normal) / length(way);
      if (leaving <= 0 || arriving <= 0) continue;
      sum += exitance.at(from) * transmittance(leaving) * transmittance(arriving) * leaving *
             arriving / dot(way, way);
    }
  const double area = 4 * std::numbers::pi * milkyRadiusMm * milkyRadiusMm / (2 * steps * steps);
  return sum * area / (std::numbers::pi * bssrdf::meanTransmittance(1.3));
}

/// The share of even light that leaves again after entering. A half-space of skin1 returns 0.4290
/// in red of the light that falls on it (slab_mc.csv of the reference tables).
double albedoOfDense() {
  return 0.4290 / bssrdf::meanTransmittance(1.3);
}

/// The light that the dense ball returns, relative to what its albedo predicts.
double lightOfAnother(const Vector& denseCentre, double albedo) {
  const Seen picture = seen(ballBesideAnother(denseCentre), 1, 64);
  const ExitanceByCosine lit(picture);
  double found = 0;
  double expected = 0;
  int pixels = 0;
  forEachOf(picture, 1, [&](const Vector& at, double exitance) {
    ++pixels;
    found += exitance;
    expected += albedo * enteringAt(at, unit(at - denseCentre), lit);
  });
  EXPECT_GT(pixels, 50);
  return found / expected;
}

TEST_F(BoundaryObjectsTest, OneLightsAnother) {
  const double albedo = albedoOfDense();
  double mean = 0;
  for (const Vector& centre : {Vector{12, 0, 7}, Vector{11, 2, 8}, Vector{12, -2, 6}}) {
    const double part = lightOfAnother(centre, albedo);
    mean += part / 3;
    EXPECT_NEAR(part, 1, 0.1) << centre[0] << ", " << centre[1] << ", " << centre[2];
  }
  EXPECT_NEAR(mean, 1, 0.05);
}

const Vector beside{12, 0, 8};

double brightestOf(const Seen& picture, float object) {
  double brightest = 0;
  forEachOf(picture, object,
            [&](const Vector&, double exitance) { brightest = std::max(brightest, exitance); });
  return brightest;
}

TEST_F(BoundaryObjectsTest, WithoutBouncesTheOtherStaysDark) {
  const Seen picture = seen(ballBesideAnother(beside), 0, 48);
  EXPECT_EQ(brightestOf(picture, 1), 0);
  EXPECT_GT(brightestOf(picture, 0), 0.5);
}

// A wall so wide that light can only get around it by way of two black surfaces.
TEST_F(BoundaryObjectsTest, NoLightGetsThroughAWall) {
  const double open = brightestOf(seen(ballBesideAnother(beside), 2, 48), 1);
  const double walled = brightestOf(
      seen(ballBesideAnother(beside, box({6.5F, 0, 2}, {0.25F, 20, 20}, 12)), 2, 48), 1);
  EXPECT_GT(open, 0.005);
  EXPECT_LT(walled, 1e-3 * open);
}

// Where bodies touch, light must leave one before it enters the other.
TEST_F(BoundaryObjectsTest, NoLightSeepsFromOneIntoAnother) {
  Scene scene = sceneOf(box({-2, 0, 0}, {2, 2, 2}, 12), skin(), {4, 0, 20}, 4);
  scene.objects.push_back({"other", box({2.001F, 0, 0}, {2, 2, 2}, 12), skin()});
  scene.lighting.directional = {{{-1, 0, 0}, {1, 1, 1}}};
  const Seen picture = seen(scene, 0, 48);
  EXPECT_EQ(brightestOf(picture, 1), 0);
  EXPECT_GT(brightestOf(picture, 0), 0.01);
}

// A glowing square below a ball, which few of a cluster's rays meet. Light does not get far in the
// ball, so its exitance goes with the irradiance of the square, ∫ cos cos / r² dA.
TEST_F(BoundaryObjectsTest, AGlowingSquareLightsABallEvenly) {
  constexpr double radiusMm = 10;
  constexpr double below = 25;  // the ball's middle, mm
  constexpr float halfMm = 5;
  Scene scene = sceneOf(sphere({0, 0, 0}, radiusMm, 5), dense(), {0, -60, -60}, 11);
  Object square{"square", sheet({0, 0, -below}, {halfMm, 0, 0}, {0, halfMm, 0}, 4), {}};
  square.opaque = OpaqueMaterial{.baseColor = {0, 0, 0}, .emission = {1, 1, 1}};
  scene.objects.push_back(square);
  const auto irradianceAt = [](const Vector& at) {
    constexpr int steps = 10;
    double sum = 0;
    for (int i = 0; i < steps * steps; ++i) {
      const double u = (i % steps + 0.5) / steps * 2 - 1;
      const double v = (i / steps + 0.5) / steps * 2 - 1;
      const Vector away = Vector{halfMm * u, halfMm * v, -below} - at;
      const double squared = dot(away, away);
      sum += std::max(dot(unit(at), away), 0.0) * std::max(-away[2], 0.0) / (squared * squared);
    }
    return sum;
  };
  RenderOptions options = boundaryOptions(128, 1);
  options.maxSurfels = 65'536;
  const std::vector<Image> images =
      renderBoundary(scene, options, {Aov::Exitance, Aov::Position}).images;
  std::vector<double> ratios;
  forEachCovered(images[0], [&](std::size_t i) {
    const Vector at = toVector(&images[1].rgba[i]);
    if (length(at) < 0.9 * radiusMm || at[2] > -0.7 * radiusMm) return;
    ratios.push_back(static_cast<double>(images[0].rgba[i + 1]) / irradianceAt(at));
  });
  ASSERT_GT(ratios.size(), 500U);
  double sum = 0;
  double squares = 0;
  for (const double ratio : ratios) {
    sum += ratio;
    squares += ratio * ratio;
  }
  const double mean = sum / static_cast<double>(ratios.size());
  EXPECT_LT(std::sqrt(squares / static_cast<double>(ratios.size()) - mean * mean) / mean, 0.19);
}

// Far from a ball that shines evenly, irradiance is M (R/d)² cos θ. Of the wall's many rays a few
// meet the ball, and none of them may stand for more than some times its light.
TEST_F(BoundaryObjectsTest, ASmallLampFarAwayLightsNoPartOfAWallBrightly) {
  constexpr float lampMm = 5;
  constexpr float farMm = 200 * lampMm;
  Scene scene = sceneOf(sphere({0, 0, 0}, lampMm, 3), marble(), {4 * lampMm, 0, 0}, farMm);
  scene.objects[0].opaque = OpaqueMaterial{.baseColor = {0, 0, 0}, .emission = {1, 1, 1}};
  Object wall{"wall", sheet({0, 0, -farMm}, {farMm / 2, 0, 0}, {0, farMm / 2, 0}, 64), {}};
  wall.opaque = OpaqueMaterial{.baseColor = {1, 1, 1}};
  scene.objects.push_back(wall);
  scene.camera.targetMm = {4 * lampMm, 0, -farMm};
  scene.camera.verticalFovDegrees = 50;
  const double largest = brightestOf(seen(scene, 2, 64), 1);
  const double most = std::numbers::pi * std::pow(lampMm / farMm, 2);
  EXPECT_GT(largest, 0);
  EXPECT_LT(largest, 15 * most);
}

}  // namespace
}  // namespace opaline
