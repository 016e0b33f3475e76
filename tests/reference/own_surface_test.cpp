// Roughness and normal textures of media in the reference, against closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "reference/bodies.h"
#include "reference/path/eye_paths.h"
#include "scene/mesh/tangents.h"

namespace opaline::reference {
namespace {

using std::numbers::pi;

constexpr double eta = 1.4;

/// Absorbs nothing, and hardly any light passes straight through the bodies below.
Medium white() {
  return {"white", {2, 2, 2}, {0, 0, 0}, eta};
}

/// A texture with one value everywhere.
Texture plainTexture(const Vector& value) {
  TexturePixels pixels;
  pixels.width = pixels.height = 1;
  for (const double part : value)
    pixels.rgba.push_back(static_cast<std::uint16_t>(std::lround(65535 * part)));
  pixels.rgba.push_back(65535);
  Texture texture;
  texture.pixels = std::make_shared<const TexturePixels>(pixels);
  return texture;
}

Texture plainNormal(const Vector& normal) {
  return plainTexture(0.5 * (normal + Vector{1, 1, 1}));
}

/// A body with texture coordinates along x and y.
Body bodyWith(Mesh mesh, const TranslucentSurface& surface) {
  for (const Vec3& place : mesh.positionsMm)
    mesh.textureCoordinates[0].push_back({place[0], -place[1]});
  Body body = test::bodyOf(mesh, white());
  body.surface = surface;
  body.textureCoordinates = mesh.textureCoordinates;
  if (surface.normalTexture) body.tangents = scene::tangentsOf(mesh, 0);
  return body;
}

Colour radianceOf(const Geometry& geometry, const PathTracer& tracer, const Vector& origin,
                  const Vector& direction, int paths) {
  const EyePaths eye(geometry, tracer, {});
  const auto hit = geometry.closestHit(origin, direction);
  Random random(5, 2);
  Colour sum{};
  for (int i = 0; i < paths; ++i) sum += eye.radiance(hit->point, -direction, random);
  return (1.0 / paths) * sum;
}

double leftFlux(const PathTracer& tracer) {
  double left = 0;
  for (const Order order : {Order::Unscattered, Order::Single, Order::Multiple})
    left += tracer.leftFlux(0, order);
  return left;
}

// The top of a box, lit from straight above; all light that enters leaves.
TEST(OwnSurfaceTest, LightEntersByTheNormalOfTheTexture) {
  for (const double tilt : {0.0, 0.5, 1.2}) {
    const Vector normal{std::sin(tilt), 0, std::cos(tilt)};
    Scene scene = test::sceneOfBodies(
        {bodyWith(test::box({0, 0, 0}, {2, 2, 1}, 1), {.normalTexture = plainNormal(normal)})});
    scene.lighting.directional = {{{0, 0, 1}, {1, 0, 0}}};
    const Geometry geometry(scene);
    PathTracer tracer(geometry, {.bounces = 0});
    tracer.run(100'000);
    const double entering = std::cos(tilt) * test::fresnelTransmittance(eta, std::cos(tilt));
    EXPECT_NEAR(leftFlux(tracer) / 16, entering, 0.01) << tilt;
  }
}

// GGX's distribution times Smith's height-correlated masking (Heitz 2014), over 4 cos in cos out,
// where the half vector is the normal.
double ggxHeadOn(double alpha, double in, double out) {
  const auto lambda = [&](double c) {
    return 0.5 * (std::sqrt(1 + alpha * alpha * (1 / (c * c) - 1)) - 1);
  };
  return 1 / (pi * alpha * alpha) / ((1 + lambda(in) + lambda(out)) * 4 * in * out);
}

// Seen from above, before anything has scattered.
TEST(OwnSurfaceTest, HighlightsHaveTheNormalAndTheRoughnessOfTheTextures) {
  const Vector normal{std::sin(0.3), 0, std::cos(0.3)};
  const double out = normal[2];
  Scene scene = test::sceneOfBodies({bodyWith(
      test::box({0, 0, 0}, {2, 2, 1}, 1), {.roughness = 0.8F,
                                           .metallicRoughnessTexture = plainTexture({1, 0.5, 1}),
                                           .normalTexture = plainNormal(normal)})});
  scene.lighting.directional = {{toVec3(2 * out * normal - Vector{0, 0, 1}), {1, 1, 1}}};
  const Geometry geometry(scene);
  const PathTracer tracer(geometry, {});
  const double found = radianceOf(geometry, tracer, {0.3, 0.2, 40}, {0, 0, -1}, 1)[0];
  const double expected =
      ggxHeadOn(0.16, out, out) * out * (1 - test::fresnelTransmittance(eta, out));
  EXPECT_NEAR(found / expected, 1, 0.001);
}

// The light that leaves a white ball and the light that it mirrors sum to its surroundings, also
// near its edge.
TEST(OwnSurfaceTest, AWhiteBallIsNotSeenInAWhiteFurnaceHoweverRough) {
  for (const float roughness : {0.1F, 0.6F}) {
    Scene scene =
        test::sceneOfBodies({bodyWith(test::sphere({0, 0, 0}, 2, 4), {.roughness = roughness})});
    scene.lighting.ambient = {0, 1, 0};
    const Geometry geometry(scene);
    PathTracer tracer(geometry, {.cellMm = 4});
    tracer.run(100'000);
    for (const double across : {0.0, 1.5, 1.95})
      EXPECT_NEAR(radianceOf(geometry, tracer, {across, 0, 40}, {0, 0, -1}, 20'000)[1], 1, 0.02)
          << roughness << " " << across;
  }
}

}  // namespace
}  // namespace opaline::reference
