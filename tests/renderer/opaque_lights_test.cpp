// Area lights on opaque surfaces, against quadrature and closed forms, pixel by pixel.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "renderer/area_light_truth.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;

class OpaqueLightsTest : public RendererTest {
 protected:
  static RenderOptions options(int pixels = 48) {
    RenderOptions options = smallOptions();
    options.transport = Transport::Boundary;
    options.width = options.height = pixels;
    options.antialias = 1;
    options.bounces = 0;
    return options;
  }

  // A white plate at y = 0, seen from above.
  static Scene plate(float halfMm, int cells, const Vec3& cameraMm = {0, 90, 1}) {
    Scene scene = sceneOf(sheet({0, 0, 0}, {0, 0, halfMm}, {halfMm, 0, 0}, cells), marble(),
                          cameraMm, 0.9F * halfMm);
    scene.objects[0].opaque = mattMaterial({1, 1, 1});
    return scene;
  }

  // A half plane below a disc hides part of it: from the left half of the plate a segment is
  // visible.
  static Scene plateBelowHalfPlane(float radius) {
    Scene scene = plate(12, 4, {0, 40, 1});
    scene.objects.push_back({.name = "half plane",
                             .mesh = sheet({-6, 50, 0}, {0, 0, 12}, {6, 0, 0}, 2),
                             .medium = marble()});
    scene.camera.verticalFovDegrees = 25;
    scene.lighting.areas = {DiscLight{{0, 100, 0}, {0, -1, 0}, radius, {500, 500, 500}}};
    return scene;
  }

  struct Found {
    Vector position;
    double irradiance;
  };

  std::vector<Found> irradianceOf(const Scene& scene, const RenderOptions& options) {
    const auto images = render(scene, options, {Aov::Position, Aov::Exitance, Aov::Object});
    std::vector<Found> found;
    forEachCovered(images[0], [&](std::size_t i) {
      if (images[2].rgba[i] != 0) return;
      found.push_back({toVector(&images[0].rgba[i]), double{images[1].rgba[i]}});
    });
    return found;
  }

  // Relative to the irradiance without an occluder.
  static double shareOf(const Found& found, const Scene& scene) {
    return found.irradiance /
           byQuadrature(scene.lighting.areas[0], found.position, 1, {0, 1, 0}, 16);
  }
};

TEST_F(OpaqueLightsTest, GiveAPlateWhatQuadratureGives) {
  for (const Site site : {Site::Fragment, Site::Vertex})
    for (const AreaLight& light : everyShape()) {
      Scene scene = plate(20, 64);
      scene.lighting.areas = {light};
      RenderOptions options = OpaqueLightsTest::options();
      options.site = site;
      double most = 0;
      std::vector<std::pair<double, double>> values;
      int number = 0;
      for (const Found& found : irradianceOf(scene, options)) {
        if (++number % 13 != 0) continue;
        values.emplace_back(found.irradiance, byQuadrature(light, found.position, 1));
        most = std::max(most, values.back().second);
      }
      ASSERT_GT(values.size(), 100U);
      std::vector<double> errors;
      for (const auto& [value, expected] : values)
        if (expected > 0.02 * most) errors.push_back(std::abs(value / expected - 1));
      EXPECT_LT(percentile95(errors), 0.03)
          << (site == Site::Vertex ? "vertices" : "fragments") << ", shape " << light.index();
    }
}

// 256 places find the visible part of a disc behind a half plane to 2 %, wherever its edge is.
TEST_F(OpaqueLightsTest, TheirPenumbraIsTheAreaOfASegment) {
  constexpr float radius = 4;
  const Scene scene = plateBelowHalfPlane(radius);
  int seen = 0;
  double squares = 0;
  for (const Found& found : irradianceOf(scene, options(128))) {
    const double x = found.position[0];
    if (std::abs(x) > 6) continue;
    ++seen;
    const double share = shareOf(found, scene);
    // Seen from x, the edge at the height 50 hides the part of the disc left of -x.
    const double error = share - shareBeyondEdge(-x, double{radius});
    EXPECT_NEAR(error, 0, 0.04) << x;
    squares += error * error;
    if (x < -4.5) {
      EXPECT_EQ(found.irradiance, 0) << x;
    } else if (x > 4.5) {
      EXPECT_NEAR(share, 1, 1e-3) << x;
    }
  }
  ASSERT_GT(seen, 4000);
  EXPECT_LT(std::sqrt(squares / seen), 0.01);
}

// A penumbra narrower than a pixel stays a few pixels wide at most.
TEST_F(OpaqueLightsTest, TheShadowOfASmallOneIsSharp) {
  constexpr float radius = 0.05F;
  constexpr int pixels = 64;
  const Scene scene = plateBelowHalfPlane(radius);
  const RenderOptions options = OpaqueLightsTest::options(pixels);
  const double pixelMm = 2 * 40 * std::tan(12.5 * std::numbers::pi / 180) / pixels;
  for (const Found& found : irradianceOf(scene, options)) {
    const double x = found.position[0];
    if (std::abs(x) > 6 || std::abs(x) < double{radius} + 2 * pixelMm) continue;
    EXPECT_NEAR(shareOf(found, scene), x < 0 ? 0 : 1, 5e-3) << x;
  }
}

// Large pictures are made in bands. Light hardly changes along the edge, so the borders of bands
// would show.
TEST_F(OpaqueLightsTest, BandsHaveNoSeams) {
  const Scene scene = plateBelowHalfPlane(4);
  RenderOptions options = OpaqueLightsTest::options();
  options.width = 4096;
  options.height = 96;
  options.antialias = 8;
  options.specular = false;
  const Image image = render(scene, options, {Aov::Radiance})[0];
  const auto value = [&](int x, int y) { return double{image.pixel(x, y)[1]}; };
  double most = 0;
  for (int x = 2048 - 24; x < 2048 + 24; ++x)
    for (int y = 2; y < options.height - 2; ++y)
      most = std::max(most, std::abs(value(x, y) - value(x, y - 1)));
  const double lit = value(2048 + 40, options.height / 2);
  ASSERT_GT(lit, 0);
  EXPECT_LT(most, 0.02 * lit);
}

}  // namespace
}  // namespace opaline
