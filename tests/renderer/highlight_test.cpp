#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>

#include "bssrdf/fresnel.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline::test {
namespace {

using HighlightTest = RendererTest;

// What a mirroring sphere sends to a point at some distance follows from the curvatures that
// reflection gives to parallel light (Coddington's equations). A polished one that is a little
// rough sends as much.
TEST_F(HighlightTest, APolishedSphereReflectsAsMuchAsAMirror) {
  constexpr double radiusMm = 10;
  constexpr double irradiance = 3;
  constexpr float seenMm = 1.6F;  // around the highlight: all but its faint rim
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
      // What a GGX lobe of that width holds within so many of its widths.
      const double alpha = static_cast<double>(roughness) * static_cast<double>(roughness);
      const double widths = static_cast<double>(seenMm) / (radiusMm * alpha);
      const double within = widths * widths / (1 + widths * widths);
      EXPECT_NEAR(reflected / (expected * within), 1, 0.03)
          << "roughness " << roughness << ", " << antialias << " samples a pixel";
    }
}

}  // namespace
}  // namespace opaline::test
