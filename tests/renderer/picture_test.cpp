// What the picture shows: output variables of an analytic sphere, coverage, and the reflection on
// top.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;

using PictureTest = RendererTest;

/// Rays of a pinhole camera through pixels' centres, reimplemented from its description.
class Rays {
 public:
  Rays(const Camera& camera, int width, int height) : width_(width), height_(height) {
    origin = toVector(camera.positionMm);
    axis = unit(toVector(camera.targetMm) - origin);
    const Vector up = toVector(camera.up);
    right_ = unit({axis[1] * up[2] - axis[2] * up[1], axis[2] * up[0] - axis[0] * up[2],
                   axis[0] * up[1] - axis[1] * up[0]});
    up_ = {right_[1] * axis[2] - right_[2] * axis[1], right_[2] * axis[0] - right_[0] * axis[2],
           right_[0] * axis[1] - right_[1] * axis[0]};
    tangent_ = std::tan(static_cast<double>(camera.verticalFovDegrees) * std::numbers::pi / 360);
  }
  Vector through(double x, double y) const {
    const double u = (2 * x / width_ - 1) * tangent_ * width_ / height_;
    const double v = (1 - 2 * y / height_) * tangent_;
    return unit(axis + u * right_ + v * up_);
  }

  Vector origin{};
  Vector axis{};

 private:
  int width_;
  int height_;
  double tangent_ = 0;
  Vector right_{};
  Vector up_{};
};

/// Distance along a ray to the nearer of its points on a sphere.
std::optional<double> meet(const Vector& origin, const Vector& direction, const Vector& centre,
                           double radius) {
  const Vector offset = origin - centre;
  const double b = dot(offset, direction);
  const double discriminant = b * b - dot(offset, offset) + radius * radius;
  if (discriminant < 0) return std::nullopt;
  return -b - std::sqrt(discriminant);
}

// Two spheres, one partly in front of the other.
TEST_F(PictureTest, VariablesAreThoseOfTheAnalyticScene) {
  const std::array<Vector, 2> centres{{{0, 0, 0}, {4, 2, 4}}};
  const std::array<double, 2> radii{5, 2};
  Scene scene = sceneOf(sphere(toVec3(centres[0]), 5), marble(), {7, 9, 22}, 7);
  scene.objects.push_back({"small", sphere(toVec3(centres[1]), 2, 4), skin()});
  scene.lighting.ambient = {1, 1, 1};
  RenderOptions options = smallOptions();
  options.width = 128;
  options.height = 96;
  const auto images = render(scene, options, {Aov::Position, Aov::Normal, Aov::Depth, Aov::Object});
  const Rays rays(scene.camera, options.width, options.height);
  std::array<int, 2> seen{};
  int disagreements = 0;
  for (int y = 0; y < options.height; ++y)
    for (int x = 0; x < options.width; ++x) {
      const Vector direction = rays.through(x + 0.5, y + 0.5);
      std::optional<double> nearest;
      std::size_t object = 0;
      for (std::size_t k = 0; k < 2; ++k) {
        const auto distance = meet(rays.origin, direction, centres[k], radii[k]);
        if (!distance || (nearest && *nearest < *distance)) continue;
        nearest = distance;
        object = k;
      }
      const bool covered = images[0].pixel(x, y)[3] > 0;
      for (const Image& image : images) ASSERT_EQ(image.pixel(x, y)[3], covered ? 1 : 0);
      if (covered != nearest.has_value() ||
          (covered && images[3].pixel(x, y)[0] != static_cast<float>(object))) {
        ++disagreements;  // the pixel's centre lies on an edge
        continue;
      }
      if (!covered) continue;
      ++seen[object];
      const Vector point = rays.origin + *nearest * direction;
      const Vector normal = unit(point - centres[object]);
      const double facing = -dot(normal, direction);
      if (facing < 0.2) continue;  // polygons and sphere differ along the ray
      const double allowed = 2e-3 * radii[object] / facing;
      EXPECT_LT(length(toVector(images[0].pixel(x, y)) - point), allowed) << x << ' ' << y;
      EXPECT_LT(length(toVector(images[1].pixel(x, y)) - normal), 0.003 / facing) << x << ' ' << y;
      EXPECT_NEAR(static_cast<double>(images[2].pixel(x, y)[0]),
                  dot(point - rays.origin, rays.axis), allowed);
    }
  EXPECT_GT(seen[0], 2000);
  EXPECT_GT(seen[1], 500);
  EXPECT_LT(disagreements, 20);
}

TEST_F(PictureTest, CoverageIsPartialOnlyAtEdges) {
  Scene scene = sceneOf(sphere({0, 0, 0}, 5), marble(), {0, 0, 20}, 6);
  scene.lighting.ambient = {1, 1, 1};
  renderer().setScene(scene);
  const Rays rays(scene.camera, 64, 64);
  const auto inside = [&](double x, double y) {
    return meet(rays.origin, rays.through(x, y), {0, 0, 0}, 5).has_value();
  };
  for (const int samples : {1, 2, 4, 8}) {
    RenderOptions options = smallOptions();
    options.antialias = samples;
    const Image image = render(options, {Aov::Radiance})[0];
    double area = 0;
    double exactArea = 0;
    int partial = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        const float alpha = image.pixel(x, y)[3];
        ASSERT_GE(alpha, 0);
        ASSERT_LE(alpha, 1);
        ASSERT_EQ(alpha * static_cast<float>(samples),
                  std::round(alpha * static_cast<float>(samples)));
        int hits = 0;
        for (int i = 0; i < 64; ++i)
          if (inside(x + (i % 8 + 0.5) / 8, y + (i / 8 + 0.5) / 8)) ++hits;
        if (hits == 64) {
          ASSERT_NEAR(alpha, 1, 0) << x << ' ' << y;
        }
        if (hits == 0) {
          ASSERT_NEAR(alpha, 0, 0) << x << ' ' << y;
        }
        if (alpha > 0 && alpha < 1) ++partial;
        area += static_cast<double>(alpha);
        exactArea += hits / 64.0;
        // Colours are not premultiplied: the edge is as bright as the pixels beside it.
        if (alpha > 0) {
          ASSERT_GT(image.pixel(x, y)[0], 0.1F);
        }
      }
    EXPECT_NEAR(area / exactArea, 1, 0.01);
    if (samples == 1) {
      EXPECT_EQ(partial, 0);
    } else {
      EXPECT_GT(partial, 60);
    }
  }
}

TEST_F(PictureTest, CameraLooksAlongItsUpDirection) {
  Scene scene = sceneOf(sphere({3, 0, 0}, 1, 3), marble(), {0, 0, 20}, 5);
  scene.lighting.ambient = {1, 1, 1};
  const auto centreOfMass = [&](const Vec3& up) {
    scene.camera.up = up;
    const Image image = render(scene, smallOptions(), {Aov::Depth})[0];
    std::array<double, 2> sum{};
    const int count = forEachCovered(image, [&](std::size_t i) {
      sum[0] += static_cast<double>(i / 4 % 64) - 31.5;
      sum[1] += static_cast<double>(i / 4 / 64) - 31.5;
    });
    return std::array<double, 2>{sum[0] / count, sum[1] / count};
  };
  EXPECT_GT(centreOfMass({0, 1, 0})[0], 10);   // +x is right
  EXPECT_LT(centreOfMass({1, 0, 0})[1], -10);  // +x is up
  EXPECT_LT(centreOfMass({0, -2, 0})[0], -10);
}

// A uniform environment looks the same as an image and as ambient light.
TEST_F(PictureTest, UniformEnvironmentIsAmbientLight) {
  Scene scene = sceneOf(sphere({0, 0, 0}, 5, 4), marble(), {0, 0, 20}, 6);
  scene.lighting.ambient = {0.5F, 1, 2};
  const Image ambient = render(scene, smallOptions(), {Aov::Radiance})[0];
  Image environment(8, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x) {
      environment.pixel(x, y)[0] = 0.5F;
      environment.pixel(x, y)[1] = 1;
      environment.pixel(x, y)[2] = 2;
    }
  scene.lighting.ambient = {};
  scene.lighting.environment = std::make_shared<const Image>(environment);
  const Image image = render(scene, smallOptions(), {Aov::Radiance})[0];
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    ASSERT_NEAR(image.rgba[i], ambient.rgba[i], 2e-3F * ambient.rgba[i]);
}

// Nothing scatters back out of a black medium, so only the reflection remains. With such a narrow
// lobe it is Fresnel's.
TEST_F(PictureTest, NarrowReflectionOfUniformLightIsFresnel) {
  Medium black{"black", {1e-4, 1e-4, 1e-4}, {50, 50, 50}, 1.5};
  Scene scene = sceneOf(sphere({0, 0, 0}, 5), black, {0, 0, 20}, 6);
  scene.lighting.ambient = {1, 1, 1};
  RenderOptions options = smallOptions();
  options.roughness = 0.05F;
  const auto images = render(scene, options, {Aov::Radiance, Aov::Position});
  forEachCovered(images[0], [&](std::size_t i) {
    const Vector position = toVector(&images[1].rgba[i]);
    const double cosine = dot(unit(position), unit(Vector{0, 0, 20} - position));
    if (cosine < 0.15) return;
    const double sineInside = std::sqrt(1 - cosine * cosine) / 1.5;
    const double inside = std::sqrt(1 - sineInside * sineInside);
    const double s = (cosine - 1.5 * inside) / (cosine + 1.5 * inside);
    const double p = (1.5 * cosine - inside) / (1.5 * cosine + inside);
    ASSERT_NEAR(static_cast<double>(images[0].rgba[i]), 0.5 * (s * s + p * p), 0.004) << cosine;
  });
}

TEST_F(PictureTest, IsTheSameEveryTimeAndFromEveryRenderer) {
  Scene scene = sceneOf(sphere({0, 0, 0}, 5, 3), marble(), {5, 6, 20}, 6);
  scene.lighting.directional = {{toVec3(unit({1, 1, -1})), {3, 2, 1}}};
  scene.lighting.points = {{{-9, 4, 3}, {100, 100, 100}}};
  const std::vector<Aov> aovs{Aov::Radiance, Aov::Exitance, Aov::DsmIrradiance, Aov::DsmArea};
  RenderOptions options = smallOptions();
  options.antialias = 2;
  options.dsmSize = 128;
  options.width = options.height = 32;
  const auto expectSame = [&](const std::vector<Image>& a, const std::vector<Image>& b) {
    for (std::size_t k = 0; k < aovs.size(); ++k) EXPECT_TRUE(a[k].rgba == b[k].rgba) << k;
  };
  for (const Sum sum : {Sum::Pattern, Sum::All}) {
    options.sum = sum;
    const auto first = render(scene, options, aovs);
    expectSame(render(options, aovs), first);
    View view(renderer(), options);
    for (int i = 0; i < 3; ++i) expectSame(view.render({.aovs = aovs}).images, first);
    Renderer other(sharedRenderer().options());
    other.setScene(scene);
    expectSame(other.render(options, aovs).images, first);
    EXPECT_EQ(other.validationMessages(), 0U);
  }
}

}  // namespace
}  // namespace opaline
