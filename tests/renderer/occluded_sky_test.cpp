// Light of the sky that enters under boundary transport, against quadrature over the unobstructed
// directions.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bssrdf/fresnel.h"
#include "environment/lat_long.h"
#include "renderer/boundary_fixture.h"

namespace opaline {
namespace {

using namespace test;

using std::numbers::pi;

using OccludedSkyTest = RendererTest;

using Radiance = std::function<double(const Vector&)>;

/// An environment equal in R, G and B.
std::shared_ptr<const Image> environmentOf(const Radiance& radiance, int height = 128) {
  Image image(2 * height, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < 2 * height; ++x) {
      const Vec3 direction = latLongDirection((x + 0.5) / (2 * height), (y + 0.5) / height);
      for (int c = 0; c < 3; ++c)
        image.pixel(x, y)[c] = static_cast<float>(radiance(toVector(direction)));
    }
  return std::make_shared<const Image>(std::move(image));
}

/// ∫ L F_t μ dω by the midpoint rule.
double entering(const Radiance& radiance, const Vector& normal, double eta) {
  constexpr int steps = 120;
  const Vector along =
      unit(cross(normal, std::abs(normal[1]) < 0.9 ? Vector{0, 1, 0} : Vector{1, 0, 0}));
  const Vector across = cross(normal, along);
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < 2 * steps; ++k) {
      const double cosine = (i + 0.5) / steps;
      const double sine = std::sqrt(1 - cosine * cosine);
      const double angle = pi * (k + 0.5) / steps;
      const Vector direction =
          cosine * normal + sine * (std::cos(angle) * along + std::sin(angle) * across);
      sum += radiance(direction) * (1 - bssrdf::fresnelReflectance(eta, cosine)) * cosine;
    }
  return sum * pi / steps / steps;
}

constexpr double radiusMm = 2;

/// Root mean square error over a ball around the origin, relative to the mean, at places with an
/// expected value.
double errorOnBall(const Scene& scene,
                   const std::function<std::optional<double>(const Vector&)>& expectedAt) {
  const RenderResult found =
      renderBoundary(scene, boundaryOptions(48), {Aov::Irradiance, Aov::Position});
  double squares = 0;
  double mean = 0;
  int pixels = 0;
  forEachCovered(found.images[0], [&](std::size_t i) {
    const Vector at = toVector(&found.images[1].rgba[i]);
    if (length(at) > 1.01 * radiusMm) return;
    const std::optional<double> expected = expectedAt(at);
    if (!expected) return;
    squares += std::pow(static_cast<double>(found.images[0].rgba[i]) - *expected, 2);
    mean += *expected;
    ++pixels;
  });
  EXPECT_GT(pixels, 500);
  return std::sqrt(squares * pixels) / mean;
}

double gradient(const Vector& direction) {
  return 1 + 0.5 * direction[0] + 0.4 * direction[1] - 0.6 * direction[2];
}

// A wall beside the ball hides almost half of the sky.
TEST_F(OccludedSkyTest, IsHiddenByDirection) {
  constexpr double wallMm = 2.2;
  constexpr double halfMm = 12;
  Scene scene = sceneOf(sphere({0, 0, 0}, radiusMm, 4), marble(), {-6, 2, 10}, 2.2F);
  scene.objects.push_back(
      {"wall", box({static_cast<float>(wallMm) + 0.5F, 0, 0}, {0.5F, halfMm, halfMm}, 8),
       marble()});
  scene.lighting.environment = environmentOf(gradient);
  const double error = errorOnBall(scene, [&](const Vector& at) {
    const auto seen = [&](const Vector& d) {
      const Vector met = at + (wallMm - at[0]) / d[0] * d;
      const bool hidden = d[0] > 0 && std::abs(met[1]) < halfMm && std::abs(met[2]) < halfMm;
      return hidden ? 0 : gradient(d);
    };
    return entering(seen, unit(at), marble().eta);
  });
  RecordProperty("rms", std::to_string(error));
  EXPECT_LT(error, 0.05);
}

// A sun in the environment becomes a light of its own. The rest has no edge sharper than a
// window's.
TEST_F(OccludedSkyTest, OnAConvexBodyIsTheIntegral) {
  const Vector toSun = unit({0.6, 0.7, 0.5});
  const double cosineOfSun = std::cos(2 * pi / 180);
  const auto radiance = [&](const Vector& d) {
    const bool window = std::abs(d[0] + 0.6) < 0.2 && std::abs(d[1] - 0.2) < 0.2 && d[2] > 0;
    return gradient(d) + (window ? 8 : 0);
  };
  Scene scene = sceneOf(sphere({0, 0, 0}, radiusMm, 4), marble(), {0, 0, 10}, 2.2F);
  constexpr int height = 256;
  scene.lighting.environment = environmentOf(
      [&](const Vector& d) { return radiance(d) + (dot(d, toSun) > cosineOfSun ? 3000 : 0); },
      height);
  double irradianceOfSun = 0;  // as the map's pixels represent it
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < 2 * height; ++x) {
      const double v = (y + 0.5) / height;
      if (dot(toVector(latLongDirection((x + 0.5) / (2 * height), v)), toSun) > cosineOfSun)
        irradianceOfSun += 3000 * pi * pi / height / height * std::sin(pi * v);
    }
  const double error = errorOnBall(scene, [&](const Vector& at) -> std::optional<double> {
    const double cosine = dot(unit(at), toSun);
    if (std::abs(cosine) < 0.1) return {};  // the terminator, softened by the shadow map's texels
    const double transmitted =
        cosine > 0 ? cosine * (1 - bssrdf::fresnelReflectance(marble().eta, cosine)) : 0;
    return entering(radiance, unit(at), marble().eta) + irradianceOfSun * transmitted;
  });
  RecordProperty("rms", std::to_string(error));
  EXPECT_LT(error, 0.05);
}

Image exitanceOf(Scene scene, const Lighting& lighting) {
  scene.lighting = lighting;
  return renderBoundary(scene, boundaryOptions(48, 2), {Aov::Exitance}).images[0];
}

TEST_F(OccludedSkyTest, OfOneColourIsAmbientLight) {
  const Scene scene = sceneOf(Bowl{10}.mesh(), marble(), {0, 0, 60}, 10.5F);
  Lighting even;
  even.environment = environmentOf([](const Vector&) { return 0.75; }, 16);
  Lighting ambient;
  ambient.ambient = {0.75F, 0.75F, 0.75F};
  const SumErrors errors = errorsOf(exitanceOf(scene, even), exitanceOf(scene, ambient));
  EXPECT_LT(errors.localLargest, 1e-4);
}

// A box that looks the same after a quarter turn about y, seen from the side to which it was
// turned.
TEST_F(OccludedSkyTest, TurnsWithTheEnvironment) {
  Scene scene = sceneOf(box({0, 0, 0}, {4, 3, 4}, 16), marble(), {0, 8, 30}, 6);
  Lighting lighting;
  lighting.environment = environmentOf(gradient);
  const Image before = exitanceOf(scene, lighting);
  // What was towards +z is now towards +x.
  lighting.environment = environmentOf([](const Vector& d) {
    return gradient({-d[2], d[1], d[0]});
  });
  scene.camera.positionMm = {30, 8, 0};
  const SumErrors errors = errorsOf(exitanceOf(scene, lighting), before);
  EXPECT_LT(errors.rms, 0.01);
}

}  // namespace
}  // namespace opaline
