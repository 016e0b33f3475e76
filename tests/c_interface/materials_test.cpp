#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "c_interface/c_fixture.h"
#include "opaline/material.h"

namespace opaline_c_test {
namespace {

struct PixelsDeleter {
  void operator()(OpalinePixels* pixels) const { opalineDestroyPixels(pixels); }
};
using Pixels = std::unique_ptr<OpalinePixels, PixelsDeleter>;

// Two by two: red, green, blue and white.
constexpr std::array<std::uint8_t, 16> squares{255, 0, 0,   255, 0,   255, 0,   255,
                                               0,   0, 255, 255, 255, 255, 255, 255};
// One for each vertex of the body.
constexpr std::array<float, 12> places{0, 0, 1, 0, 0, 1, 1, 1, 0.5F, 0, 0, 0.5F};
constexpr std::array<float, 24> colors{1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1,
                                       1, 1, 0, 1, 0, 1, 1, 1, 1, 0, 1, 1};

Pixels pixelsOf(const void* rgba, int bits) {
  OpalinePixels* pixels = nullptr;
  EXPECT_EQ(opalineCreatePixels(rgba, bits, 2, 2, &pixels), OpalineOk) << opalineLastError();
  return Pixels(pixels);
}

OpalineTexture textureOf(const Pixels& pixels) {
  OpalineTexture texture{};
  texture.size = sizeof texture;
  EXPECT_EQ(opalineDefaultTexture(&texture), OpalineOk);
  texture.pixels = pixels.get();
  texture.wrapU = texture.wrapV = OpalineWrapClampToEdge;
  texture.interpolated = 0;
  return texture;
}

opaline::Texture sameTexture() {
  auto pixels = std::make_shared<opaline::TexturePixels>();
  pixels->width = pixels->height = 2;
  for (const std::uint8_t value : squares)
    pixels->rgba.push_back(value == 255 ? std::numeric_limits<std::uint16_t>::max() : 0);
  opaline::Texture texture;
  texture.pixels = pixels;
  texture.wrapU = texture.wrapV = opaline::TextureWrap::ClampToEdge;
  texture.interpolated = false;
  return texture;
}

opaline::Scene sameSceneWithPlaces() {
  opaline::Scene scene = sameScene(Body());
  for (std::size_t i = 0; i < places.size(); i += 2)
    scene.objects[0].mesh.textureCoordinates[0].push_back({places[i], places[i + 1]});
  return scene;
}

Scene sceneWithPlaces() {
  Scene scene = sceneOf(Body());
  EXPECT_EQ(opalineSetObjectTextureCoordinates(scene.get(), 0, 0, places.data(), 6, 0), OpalineOk);
  return scene;
}

TEST(CInterfaceMaterials, PaintByTextureAndVerticesIsThatOfTheCppInterface) {
  const Scene scene = sceneWithPlaces();
  const Drawn drawn(scene);
  const std::vector<float> plain = drawn.picture();
  opaline::Scene same = sameSceneWithPlaces();

  const Pixels pixels = pixelsOf(squares.data(), 8);
  const OpalineTexture texture = textureOf(pixels);
  const OpalinePaint paint{sizeof paint, {0.8F, 0.7F, 0.6F}, &texture};
  ASSERT_EQ(opalineSetObjectPaint(scene.get(), 0, &paint), OpalineOk) << opalineLastError();
  ASSERT_EQ(opalineSetMaterial(drawn.renderer.get(), 0, scene.get()), OpalineOk)
      << opalineLastError();
  same.objects[0].paint =
      opaline::Paint{.name = {}, .color = {0.8F, 0.7F, 0.6F}, .colorTexture = sameTexture()};
  const std::vector<float> painted = drawn.picture();
  EXPECT_EQ(painted, samePicture(same, drawn));
  EXPECT_NE(painted, plain);

  ASSERT_EQ(opalineSetObjectColors(scene.get(), 0, colors.data(), 6, 0), OpalineOk);
  ASSERT_EQ(opalineSetScene(drawn.renderer.get(), scene.get()), OpalineOk);
  for (std::size_t i = 0; i < colors.size(); i += 4)
    same.objects[0].mesh.colors.push_back({colors[i], colors[i + 1], colors[i + 2], colors[i + 3]});
  const std::vector<float> colored = drawn.picture();
  EXPECT_EQ(colored, samePicture(same, drawn));
  EXPECT_NE(colored, painted);
}

TEST(CInterfaceMaterials, SurfacesAndOpaqueMaterialsAreThoseOfTheCppInterface) {
  const Scene scene = sceneWithPlaces();
  const Drawn drawn(scene);
  opaline::Scene same = sameSceneWithPlaces();

  const float roughness = 0.6F;
  OpalineSurface surface{};
  surface.size = sizeof surface;
  ASSERT_EQ(opalineDefaultSurface(&surface), OpalineOk);
  EXPECT_EQ(surface.normalScale, 1);
  surface.roughness = &roughness;
  const std::vector<float> before = drawn.picture(OpalineAovRadiance);
  ASSERT_EQ(opalineSetObjectSurface(scene.get(), 0, &surface), OpalineOk);
  ASSERT_EQ(opalineSetScene(drawn.renderer.get(), scene.get()), OpalineOk);
  same.objects[0].surface = opaline::TranslucentSurface{
      .roughness = roughness, .metallicRoughnessTexture = {}, .normalTexture = {}};
  const std::vector<float> rough = drawn.picture(OpalineAovRadiance);
  EXPECT_EQ(rough, samePicture(same, drawn, opaline::Aov::Radiance));
  EXPECT_NE(rough, before);

  OpalineOpaqueMaterial opaque{};
  opaque.size = sizeof opaque;
  ASSERT_EQ(opalineDefaultOpaqueMaterial(&opaque), OpalineOk);
  EXPECT_EQ(opaque.ior, 1.5F);
  const Pixels pixels = pixelsOf(squares.data(), 8);
  const OpalineTexture texture = textureOf(pixels);
  opaque.baseColorTexture = &texture;
  opaque.metallic = 0.25F;
  opaque.roughness = 0.5F;
  opaque.baseColor[1] = 0.9F;
  opaque.emission[2] = 0.125F;
  opaque.diffuseTransmission = 0.5F;
  opaque.diffuseTransmissionColor[0] = 0.25F;
  opaque.diffuseTransmissionTexture = &texture;
  ASSERT_EQ(opalineSetObjectOpaque(scene.get(), 0, &opaque), OpalineOk) << opalineLastError();
  ASSERT_EQ(opalineSetScene(drawn.renderer.get(), scene.get()), OpalineOk);
  opaline::OpaqueMaterial& sameOpaque = same.objects[0].opaque.emplace();
  sameOpaque.baseColorTexture = sameTexture();
  sameOpaque.metallic = 0.25F;
  sameOpaque.roughness = 0.5F;
  sameOpaque.baseColor[1] = 0.9F;
  sameOpaque.emission[2] = 0.125F;
  sameOpaque.diffuseTransmission = 0.5F;
  sameOpaque.diffuseTransmissionColor[0] = 0.25F;
  sameOpaque.diffuseTransmissionTexture = sameTexture();
  EXPECT_EQ(drawn.picture(OpalineAovRadiance), samePicture(same, drawn, opaline::Aov::Radiance));

  ASSERT_EQ(opalineSetObjectOpaque(scene.get(), 0, nullptr), OpalineOk);
  ASSERT_EQ(opalineSetObjectSurface(scene.get(), 0, nullptr), OpalineOk);
  ASSERT_EQ(opalineSetScene(drawn.renderer.get(), scene.get()), OpalineOk);
  EXPECT_EQ(drawn.picture(OpalineAovRadiance), before);
}

TEST(CInterfaceMaterials, RefusesWhatMakesNoSense) {
  const Scene scene = sceneWithPlaces();
  OpalinePixels* none = nullptr;
  EXPECT_EQ(opalineCreatePixels(squares.data(), 12, 2, 2, &none), OpalineBadUse);
  EXPECT_EQ(opalineCreatePixels(squares.data(), 8, 0, 2, &none), OpalineBadUse);
  EXPECT_EQ(opalineCreatePixels(squares.data(), 8, 2, 16385, &none), OpalineBadUse);
  EXPECT_EQ(opalineCreatePixels(nullptr, 8, 2, 2, &none), OpalineBadUse);
  EXPECT_EQ(none, nullptr);
  OpalineTexture texture = textureOf(Pixels());
  OpalinePaint paint{sizeof paint, {1, 1, 1}, &texture};
  EXPECT_EQ(opalineSetObjectPaint(scene.get(), 0, &paint), OpalineBadUse) << "without pixels";
  paint = {sizeof paint, {-1, 1, 1}, nullptr};
  EXPECT_EQ(opalineSetObjectPaint(scene.get(), 0, &paint), OpalineBadUse);
  EXPECT_EQ(opalineSetObjectPaint(scene.get(), 1, nullptr), OpalineBadUse);
  EXPECT_EQ(opalineSetObjectColors(scene.get(), 0, colors.data(), 5, 0), OpalineBadUse);
  EXPECT_EQ(opalineSetObjectColors(scene.get(), 0, colors.data(), 6, 12), OpalineBadUse);
  EXPECT_EQ(opalineSetObjectTextureCoordinates(scene.get(), 0, 2, places.data(), 6, 0),
            OpalineBadUse);
  std::array<float, 24> broken = colors;
  broken[7] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(opalineSetObjectColors(scene.get(), 0, broken.data(), 6, 0), OpalineOk);
  OpalineRenderer* renderer = nullptr;
  ASSERT_EQ(opalineCreateRenderer(nullptr, &renderer), OpalineOk);
  const Renderer owned(renderer);
  EXPECT_EQ(opalineSetScene(renderer, scene.get()), OpalineFailed);
}

TEST(CInterfaceMaterials, MediaOfEitherColorModelAreThoseOfTheCppInterface) {
  OpalineAppearance appearance{};
  appearance.size = sizeof appearance;
  ASSERT_EQ(opalineDefaultAppearance(&appearance), OpalineOk);
  appearance.color[0] = 0.5;
  appearance.meanFreePathMm[2] = 2;
  OpalineMedium observed{};
  observed.size = sizeof observed;
  OpalineMedium khr = observed;
  ASSERT_EQ(opalineMediumOfAppearance(&appearance, &observed), OpalineOk);
  appearance.colorModel = OpalineColorKhr;
  ASSERT_EQ(opalineMediumOfAppearance(&appearance, &khr), OpalineOk);
  opaline::Appearance same;
  same.color[0] = 0.5;
  same.meanFreePathMm[2] = 2;
  EXPECT_EQ(observed.sigmaAPerMm[0], opaline::mediumOf(same).sigmaAPerMm[0]);
  same.colorModel = opaline::ColorModel::Khr;
  EXPECT_EQ(khr.sigmaAPerMm[0], opaline::mediumOf(same).sigmaAPerMm[0]);
  EXPECT_GT(khr.sigmaAPerMm[0], observed.sigmaAPerMm[0]) << "seen darker, as ColorModel says";
  std::array<float, 3> color{};
  ASSERT_EQ(opalineColorOfMedium(&observed, color.data()), OpalineOk);
  EXPECT_NEAR(color[0], 0.5, 0.003);
  EXPECT_NEAR(color[1], 0.8, 0.003);
}

}  // namespace
}  // namespace opaline_c_test
