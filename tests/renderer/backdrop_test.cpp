// The picture where there is no surface: visible lights and the environment.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "lights/area.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;
using std::numbers::pi;

constexpr int size = 96;
constexpr double infinity = std::numeric_limits<double>::infinity();

class BackdropTest : public RendererTest {
 protected:
  static RenderOptions options() {
    RenderOptions options = smallOptions();
    options.width = options.height = size;
    options.antialias = 1;
    options.specular = false;
    return options;
  }

  // A ball around the origin, seen at an angle.
  static Scene ball() { return sceneOf(sphere({0, 0, 0}, 5, 3), marble(), {30, 12, 25}, 12); }

  Image radiance(const Scene& scene, const RenderOptions& options) {
    return render(scene, options, {Aov::Radiance}).at(0);
  }

  // The ray through a pixel's centre, from the camera's angles.
  static Vector sight(const Camera& camera, int x, int y) {
    const Vector axis = unit(toVector(camera.targetMm) - toVector(camera.positionMm));
    const Vector right = unit(cross(axis, toVector(camera.up)));
    const Vector up = cross(right, axis);
    const double reach = std::tan(static_cast<double>(camera.verticalFovDegrees) * pi / 360);
    return unit(axis + reach * ((2 * x + 1.0) / size - 1) * right +
                reach * (1 - (2 * y + 1.0) / size) * up);
  }
};

double brightness(const Vector& direction, std::size_t channel) {
  return 1 + 0.5 * direction[channel] + 0.2 * direction[(channel + 1) % 3];
}

std::shared_ptr<const Image> smoothEnvironment() {
  auto image = std::make_shared<Image>(128, 64);
  for (int y = 0; y < image->height; ++y)
    for (int x = 0; x < image->width; ++x) {
      const double polar = pi * (y + 0.5) / image->height;
      const double azimuth = 2 * pi * ((x + 0.5) / image->width - 0.5);
      const Vector direction{std::sin(polar) * std::sin(azimuth), std::cos(polar),
                             -std::sin(polar) * std::cos(azimuth)};
      for (std::size_t c = 0; c < 3; ++c)
        image->pixel(x, y)[c] = static_cast<float>(brightness(direction, c));
    }
  return image;
}

TEST_F(BackdropTest, EnvironmentAndAmbientLightFillWhatNoSurfaceCovers) {
  Scene scene = ball();
  scene.lighting.environment = smoothEnvironment();
  scene.lighting.ambient = {0.5F, 0.25F, 0};
  RenderOptions options = BackdropTest::options();
  const Image without = radiance(scene, options);
  options.environmentBehind = true;
  const Image with = radiance(scene, options);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      ASSERT_EQ(with.pixel(x, y)[3], 1);
      const bool body = without.pixel(x, y)[3] > 0;
      const Vector direction = sight(scene.camera, x, y);
      for (std::size_t c = 0; c < 3; ++c) {
        const double behind =
            brightness(direction, c) + static_cast<double>(scene.lighting.ambient[c]);
        ASSERT_NEAR(static_cast<double>(with.pixel(x, y)[c]),
                    body ? static_cast<double>(without.pixel(x, y)[c]) : behind, 2e-3)
            << x << ' ' << y;
      }
    }
}

TEST_F(BackdropTest, VisibleLightsStandWhereTheyAre) {
  Scene scene = ball();
  // Lights in front of the ball and behind it, and a disc seen from its back.
  scene.lighting.areas = {RectangleLight{{9, 2, -8}, {0, 4, 1}, {-3, 1, 3}, {2, 3, 4}, true, true},
                          DiscLight{{-4, -7, 6}, {1, 0.5F, 1}, 2.5F, {5, 1, 2}, false, true},
                          DiscLight{{6, 7, 2}, {-1, -0.5F, -1}, 3, {9, 9, 9}, false, true},
                          SphereLight{{5, 3, 6}, 1.5F, {1, 7, 3}, true},
                          TubeLight{{-12, 5, 0}, {10, -5, 8}, 0.6F, {8, 2, 6}, true},
                          SphereLight{{-2, 9, 0}, 2, {9, 9, 9}, false}};
  const RenderOptions options = BackdropTest::options();
  const Image seen = radiance(scene, options);
  Scene hidden = scene;
  for (AreaLight& light : hidden.lighting.areas)
    std::visit([](auto& shape) { shape.visible = false; }, light);
  const std::vector<Image> body = render(hidden, options, {Aov::Radiance, Aov::Depth});
  const Vector camera = toVector(scene.camera.positionMm);
  const Vector axis = unit(toVector(scene.camera.targetMm) - camera);
  int lit = 0;
  int wrong = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const Vector direction = sight(scene.camera, x, y);
      const bool covered = body[0].pixel(x, y)[3] > 0;
      double nearest =
          covered ? static_cast<double>(body[1].pixel(x, y)[0]) / dot(direction, axis) : infinity;
      const float* expected = body[0].pixel(x, y);
      Rgb light{};
      for (const AreaLight& area : scene.lighting.areas) {
        const auto distance = distanceAlong(camera, direction, area);
        if (!isVisible(area) || !distance || *distance >= nearest) continue;
        nearest = *distance;
        light = radianceOf(area);
        expected = light.data();
      }
      if (expected == light.data()) ++lit;
      const bool any = covered || expected == light.data();
      bool same = (seen.pixel(x, y)[3] > 0) == any;
      for (int c = 0; c < 3; ++c)
        same = same && std::abs(seen.pixel(x, y)[c] - expected[c]) <= 1e-3F * (1 + expected[c]);
      if (!same) ++wrong;
    }
  EXPECT_GT(lit, 1000);
  EXPECT_LE(wrong, 4);  // pixels whose centre lies on an edge within rounding
}

TEST_F(BackdropTest, EdgesOfLightsAreSmooth) {
  Scene scene = ball();
  scene.lighting.areas = {SphereLight{{5, 3, 6}, 1.5F, {1, 1, 1}, true}};
  RenderOptions options = BackdropTest::options();
  options.antialias = 8;
  options.environmentBehind = true;
  scene.lighting.ambient = {1, 1, 1};
  const Image image = radiance(scene, options);
  // A light as bright as its background leaves no visible rim outside the body.
  const RenderOptions plain = BackdropTest::options();
  const Image body = radiance(scene, plain);
  for (int y = 1; y + 1 < size; ++y)
    for (int x = 1; x + 1 < size; ++x) {
      bool free = true;
      for (int i = 0; i < 9; ++i)
        free = free && (body.pixel(x + i % 3 - 1, y + i / 3 - 1)[3] == 0 ||
                        body.pixel(x + i % 3 - 1, y + i / 3 - 1)[0] == 1);
      if (!free) continue;
      ASSERT_NEAR(image.pixel(x, y)[0], 1, 1e-5) << x << ' ' << y;
    }
}

}  // namespace
}  // namespace opaline
