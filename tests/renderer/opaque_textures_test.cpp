// Textures of opaque materials: how they are read, the holes that they cut, and the way the surface
// faces.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "renderer/opaque_fixture.h"

namespace opaline {
namespace {

using namespace test;
using std::numbers::pi;

TEST_F(OpaqueTest, TexturesAreLinearBeforeTheyAreInterpolated) {
  OpaqueMaterial material = mattMaterial({1, 1, 1});
  Texture texture;
  texture.pixels = texturePixels(2, {{0, 0, 0, 1}, {1, 1, 1, 1}});
  texture.wrapU = TextureWrap::ClampToEdge;
  material.baseColorTexture = texture;
  Scene scene = squareOf(material);
  scene.lighting.directional.push_back({{0, 0, 1}, {3, 3, 3}});
  // The middle has the mean of black and white light, not of their encoded values.
  const Image image = render(scene, options(), {Aov::Radiance})[0];
  const int middle = edgePixels / 2;
  const double between = 0.5 * (double{image.pixel(middle, 3)[1]} + image.pixel(middle - 1, 3)[1]);
  EXPECT_NEAR(between, 0.5 * 3 / pi, 0.01);
  EXPECT_NEAR(double{image.pixel(1, 3)[0]}, 0, 1e-3);
  EXPECT_NEAR(double{image.pixel(edgePixels - 2, 3)[2]}, 3 / pi, 0.003);
}

// IEC 61966-2-1.
TEST_F(OpaqueTest, ColoursOfTexelsAreThoseOfTheFileUpsideUp) {
  OpaqueMaterial material = mattMaterial({1, 0.5F, 1});
  Texture texture;
  texture.pixels = texturePixels(2, {{0.5, 0.5, 0, 1}, {0, 0, 1, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}});
  texture.interpolated = false;
  material.baseColorTexture = texture;
  Scene scene = squareOf(material);
  scene.lighting.directional.push_back({{0, 0, 1}, {1, 1, 1}});
  const double half = std::pow((0.5 + 0.055) / 1.055, 2.4);
  const Image image = render(scene, options(), {Aov::Radiance})[0];
  const auto expectAt = [&](int x, int y, const Vector& color) {
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(double{image.pixel(x, y)[c]}, color[c] / pi, 1e-3) << x << " " << y << " " << c;
  };
  expectAt(8, 8, {half, 0.5 * half, 0});
  expectAt(24, 8, {0, 0, 1});
  expectAt(8, 24, {1, 0, 0});
  expectAt(24, 24, {0, 0.5, 0});
}

// A fine checker in the distance shows its mean and does not shimmer.
TEST_F(OpaqueTest, FarTexturesAreTheirMean) {
  OpaqueMaterial material = mattMaterial({1, 1, 1});
  Texture texture;
  texture.pixels = texturePixels(2, {{1, 1, 1, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}, {1, 1, 1, 1}});
  texture.transform = {{{301, 0, 0}, {0, 303, 0}}};
  material.baseColorTexture = texture;
  Scene scene = squareOf(material);
  scene.lighting.directional.push_back({{0, 0, 1}, {1, 1, 1}});
  const Image image = render(scene, options(), {Aov::Radiance})[0];
  for (int y = 2; y < edgePixels; y += 5)
    for (int x = 1; x < edgePixels; x += 3)
      EXPECT_NEAR(double{image.pixel(x, y)[1]}, 0.5 / pi, 2e-3);
}

// A texture tilts the normal of a square: Lambert's cosine follows.
TEST_F(OpaqueTest, NormalTexturesTurnTheSurface) {
  OpaqueMaterial material = mattMaterial({1, 1, 1});
  const double tilt = 0.5;  // towards +x and, as green is up, +y
  const double s = std::sin(tilt) / std::sqrt(2.0);
  Texture texture;
  texture.pixels =
      texturePixels(1, {{0.5 + 0.5 * s, 0.5 + 0.5 * s, 0.5 + 0.5 * std::cos(tilt), 1}});
  material.normalTexture = texture;
  Scene scene = squareOf(material);
  const Vector light{0.6, 0.2, std::sqrt(1 - 0.4)};
  scene.lighting.directional.push_back(
      {{static_cast<float>(light[0]), static_cast<float>(light[1]), static_cast<float>(light[2])},
       {1, 1, 1}});
  const double cosine = s * light[0] + s * light[1] + std::cos(tilt) * light[2];
  EXPECT_NEAR(radianceAt(scene, 9, 20)[0], cosine / pi, 2e-3);
}

TEST_F(OpaqueTest, AlphaCutsHoles) {
  OpaqueMaterial material = mattMaterial({1, 1, 1});
  Texture texture;
  texture.pixels = texturePixels(2, {{1, 1, 1, 0}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 0}});
  texture.interpolated = false;
  material.baseColorTexture = texture;
  material.alphaCutoff = 0.5F;
  Scene scene = squareOf(material);
  // Behind the first, so that light only comes through the holes.
  scene.objects.push_back(squareOf(mattMaterial({1, 1, 1})).objects[0]);
  for (Vec3& place : scene.objects[1].mesh.positionsMm) place[2] -= 2;
  scene.lighting.directional.push_back({{0, 0, 1}, {1, 1, 1}});
  const auto images = render(scene, options(), {Aov::Radiance, Aov::Object});
  EXPECT_EQ(images[1].pixel(8, 8)[0], 1);
  EXPECT_EQ(images[1].pixel(24, 8)[0], 0);
  EXPECT_EQ(images[1].pixel(8, 24)[0], 0);
  EXPECT_EQ(images[1].pixel(24, 24)[0], 1);
  for (const int at : {8, 24}) EXPECT_NEAR(double{images[0].pixel(at, at)[0]}, 1 / pi, 0.01);
}

TEST_F(OpaqueTest, AlphaCutsHolesWithoutATextureToo) {
  OpaqueMaterial material = mattMaterial({1, 1, 1});
  material.alphaCutoff = 0.5F;
  Scene scene = squareOf(material);
  scene.lighting.directional.push_back({{0, 0, 1}, {1, 1, 1}});
  const auto depthOf = [&] { return render(scene, options(), {Aov::Depth})[0].pixel(16, 16)[0]; };
  const float ofWhole = depthOf();
  EXPECT_GT(ofWhole, 0);
  scene.objects[0].opaque->alpha = 0.4F;
  EXPECT_EQ(depthOf(), 0);
  // Holes that a material gets later.
  scene.objects[0].opaque->alphaCutoff = 0;
  EXPECT_EQ(depthOf(), ofWhole);
  View view(renderer(), options());
  material.alpha = 0.6F;
  renderer().setMaterial(0, {.opaque = material});
  EXPECT_EQ(view.render({.aovs = {Aov::Depth}}).images[0].pixel(16, 16)[0], ofWhole);
  material.alpha = 0.4F;
  renderer().setMaterial(0, {.opaque = material});
  EXPECT_EQ(view.render({.aovs = {Aov::Depth}}).images[0].pixel(16, 16)[0], 0);
}

// Surfaces are listed in any order, so that different ones are processed together each time.
TEST_F(OpaqueTest, APictureWithTexturesIsTheSameEachTime) {
  constexpr int size = 64;
  std::vector<std::array<double, 4>> texels;
  for (int i = 0; i < size * size; ++i) {
    const double level = (i / 8 + i / size / 8) % 2 == 0 ? 0.9 : 0.1;
    texels.push_back({level, level, level, 1});
  }
  OpaqueMaterial material = mattMaterial({1, 1, 1});
  material.baseColorTexture = Texture{.pixels = texturePixels(size, texels)};
  Scene scene = squareOf(material);
  scene.camera.positionMm = {60, 20, 40};
  scene.camera.verticalFovDegrees = 25;
  scene.lighting.ambient = {1, 1, 1};
  RenderOptions large = options();
  large.width = large.height = 256;
  large.antialias = 4;
  sharedRenderer().renderer->setScene(scene);
  const Image first = sharedRenderer().renderer->render(large, {Aov::Radiance}).images[0];
  for (int i = 0; i < 8; ++i)
    EXPECT_EQ(sharedRenderer().renderer->render(large, {Aov::Radiance}).images[0].rgba, first.rgba);
}

}  // namespace
}  // namespace opaline
