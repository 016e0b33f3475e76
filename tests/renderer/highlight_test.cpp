#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "bssrdf/fresnel.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline::test {
namespace {

using HighlightTest = RendererTest;

// What a mirroring sphere sends to a distant point follows from the curvature that reflection gives
// to parallel light (Coddington's equations). A slightly rough polished sphere sends the same
// amount.
TEST_F(HighlightTest, APolishedSphereReflectsAsMuchAsAMirror) {
  constexpr double radiusMm = 10;
  constexpr double irradiance = 3;
  constexpr float seenMm = 1.6F;  // around the highlight: everything but its faint rim
  const Vector camera{0, 0, 180};
  const Vector normal = unit({0.5, 0, 0.8});
  const Vector highlight = radiusMm * normal;
  const Vector toCamera = unit(camera - highlight);
  const double cosine = dot(normal, toCamera);
  Scene scene = sceneOf(sphere({0, 0, 0}, radiusMm), marble(), toVec3(camera), seenMm);
  scene.camera.targetMm = toVec3(highlight);
  scene.lighting.directional = {{toVec3(2 * cosine * normal - toCamera), {irradiance, 1, 1}}};
  const double distance = length(camera - highlight);
  const double expected =
      irradiance * bssrdf::fresnelReflectance(marble().eta, cosine) /
      ((1 + 2 * distance / (radiusMm * cosine)) * (1 + 2 * distance * cosine / radiusMm));

  RenderOptions options = smallOptions();
  options.width = options.height = 128;
  const double halfFov =
      static_cast<double>(scene.camera.verticalFovDegrees) / 2 * std::numbers::pi / 180;
  const double pixel = 2 * std::tan(halfFov) / options.width;  // rad
  for (const float roughness : {0.1F, 0.2F})
    for (const int antialias : {1, 4}) {
      options.roughness = roughness;
      options.antialias = antialias;
      options.specular = true;
      const Image with = render(scene, options, {Aov::Radiance})[0];
      options.specular = false;
      const Image without = render(options, {Aov::Radiance})[0];
      double reflected = 0;
      forEachCovered(with, [&](std::size_t i) {
        reflected += static_cast<double>(with.rgba[i] - without.rgba[i]) * pixel * pixel;
      });
      // The part of a GGX lobe of that width within so many of its widths.
      const double alpha = static_cast<double>(roughness) * static_cast<double>(roughness);
      const double widths = static_cast<double>(seenMm) / (radiusMm * alpha);
      const double within = widths * widths / (1 + widths * widths);
      EXPECT_NEAR(reflected / (expected * within), 1, 0.03)
          << "roughness " << roughness << ", " << antialias << " samples a pixel";
    }
}

double ggx(double alpha, const Vector& normal, const Vector& toLight, const Vector& toCamera) {
  const double in = dot(normal, toLight);
  const double out = dot(normal, toCamera);
  if (in <= 0 || out <= 0) return 0;
  const Vector half = unit(toLight + toCamera);
  const double squared = alpha * alpha;
  const double t = dot(normal, half) * dot(normal, half) * (squared - 1) + 1;
  const auto masked = [&](double a, double b) {
    return a * std::sqrt(b * b * (1 - squared) + squared);
  };
  return squared / (std::numbers::pi * t * t) * 0.5 / (masked(in, out) + masked(out, in)) *
         bssrdf::fresnelReflectance(marble().eta, dot(toLight, half)) * in;
}

// A sun is mirrored as a disc with the right brightness in the middle, total light and width, which
// follow from the integral of the lobe over the disc.
TEST_F(HighlightTest, ASunIsMirroredAsADisc) {
  constexpr double radiusMm = 10;
  constexpr float seenMm = 2;
  constexpr float degrees = 2.5F;
  const double theta = static_cast<double>(degrees) * std::numbers::pi / 180;
  const Vector camera{0, 0, 180};
  for (const Vector& direction : {Vector{0.1, 0, 1}, Vector{0.8, 0, 0.6}}) {
    const Vector normal = unit(direction);
    const Vector toCamera = unit(camera - radiusMm * normal);
    const double cosine = dot(normal, toCamera);
    const Vector toSun = 2 * cosine * normal - toCamera;
    const Vector along = unit(cross(toSun, {0, 1, 0}));
    const Vector across = cross(toSun, along);
    Scene scene = sceneOf(sphere({0, 0, 0}, radiusMm), marble(), toVec3(camera), seenMm);
    scene.camera.targetMm = toVec3(radiusMm * normal);
    scene.lighting.directional = {{toVec3(toSun), {1, 1, 1}, degrees}};
    const auto mirrored = [&](double alpha, const Vector& place) {
      constexpr int rings = 12;
      double sum = 0;
      for (int i = 0; i < rings; ++i)
        for (int k = 0; k < 2 * rings; ++k) {
          const double away = std::tan(theta * std::sqrt((i + 0.5) / rings));
          const double angle = std::numbers::pi * (k + 0.5) / rings;
          sum += ggx(alpha, unit(place),
                     unit(toSun + away * (std::cos(angle) * along + std::sin(angle) * across)),
                     unit(camera - place));
        }
      return sum / (2 * rings * rings);
    };
    RenderOptions options = smallOptions();
    for (const float roughness : {0.08F, 0.15F, 0.25F}) {
      options.roughness = roughness;
      options.specular = true;
      const std::vector<Image> with = render(scene, options, {Aov::Radiance, Aov::Position});
      options.specular = false;
      const Image without = render(options, {Aov::Radiance})[0];
      const double alpha = static_cast<double>(roughness) * static_cast<double>(roughness);
      double found = 0;
      double expected = 0;
      double peak = 0;
      double expectedPeak = 0;
      double squares = 0;
      double expectedSquares = 0;
      forEachCovered(with[0], [&](std::size_t i) {
        const double value = static_cast<double>(with[0].rgba[i] - without.rgba[i]);
        const double wanted = mirrored(alpha, toVector(&with[1].rgba[i]));
        found += value;
        expected += wanted;
        squares += value * value;
        expectedSquares += wanted * wanted;
        peak = std::max(peak, value);
        expectedPeak = std::max(expectedPeak, wanted);
      });
      const double width =
          std::sqrt(found * found / squares / (expected * expected / expectedSquares));
      const std::string which = fmt::format("roughness {}, cosine {:.2f}", roughness, cosine);
      EXPECT_NEAR(found / expected, 1, 0.03) << which;
      EXPECT_NEAR(peak / expectedPeak, 1, 0.1) << which;
      // A polished surface mirrors a disc with a sharp edge; a lobe has none.
      EXPECT_NEAR(width, 1, roughness > 0.2F ? 0.05 : 0.5) << which;
    }
  }
}

}  // namespace
}  // namespace opaline::test
