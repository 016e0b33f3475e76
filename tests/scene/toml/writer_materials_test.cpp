// Materials in scene files, written and loaded again.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "opaline/image_file.h"
#include "opaline/media.h"
#include "scene/material.h"
#include "scene/toml/writer_fixture.h"

namespace opaline {
namespace {

using testing::HasSubstr;

TEST_F(SceneWriter, MaterialsComeBack) {
  writePng(folder / "grey.png", {1, 1, {188, 188, 188, 255}});
  test::writeBytes(file(), R"(
model = "../../models/cubes.glb"
[materials.brass]
kind = "opaque"
base_color = [0.9, 0.7, 0.3]
metallic = 1
roughness = 0.25
diffuse_transmission = 0.125
diffuse_transmission_color_texture = "../../grey.png"
base_color_texture = "../../grey.png"
[materials.jelly]
kind = "translucent"
color = [0.9, 0.5, 0.1]
mean_free_path_mm = 2
ball_mm = 40
eta = 1.5
[materials.cheese]
kind = "translucent"
color_texture = "../../grey.png"
mean_free_path_mm = [1, 2, 4]
roughness = 0.5
normal_texture = "../../grey.png"
)"
                           "[objects.plain]\nmaterial = \"brass\"\n[objects.\"" +
                               escaped(names[1]) + "\"]\nmaterial = \"jelly\"\n[objects.\"" +
                               escaped(names[2]) + "\"]\nmaterial = \"cheese\"\n");
  const LoadedScene first = back();
  const Scene& scene = first.scene;
  ASSERT_TRUE(scene.objects[0].opaque);
  EXPECT_EQ(scene.objects[0].opaque->baseColor, (Rgb{0.9F, 0.7F, 0.3F}));
  EXPECT_EQ(scene.objects[0].opaque->roughness, 0.25F);
  EXPECT_EQ(scene.objects[0].opaque->baseColorTexture->pixels->rgba[0], 188 * 257);
  EXPECT_EQ(scene.objects[0].opaque->diffuseTransmission, 0.125F);
  EXPECT_TRUE(scene.objects[0].opaque->diffuseTransmissionColorTexture);
  const Appearance jelly{{0.9, 0.5, 0.1}, {2, 2, 2}, 0, 1.5, ColorModel::Observed, 40};
  EXPECT_EQ(scene.objects[1].medium.sigmaAPerMm, mediumOf(jelly).sigmaAPerMm);
  EXPECT_FALSE(scene.objects[1].surface);
  ASSERT_TRUE(scene.objects[2].surface && scene.objects[2].surface->normalTexture);
  EXPECT_EQ(scene.objects[2].surface->roughness, 0.5F);
  written(first);
  const LoadedScene second = back();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = second.scene.objects[i];
    EXPECT_EQ(object.medium, scene.objects[i].medium);
    ASSERT_EQ(object.surface.has_value(), scene.objects[i].surface.has_value());
    if (object.surface) {
      EXPECT_EQ(object.surface->roughness, scene.objects[i].surface->roughness);
      EXPECT_EQ(object.surface->normalTexture->pixels->rgba,
                scene.objects[i].surface->normalTexture->pixels->rgba);
    }
    ASSERT_EQ(object.opaque.has_value(), scene.objects[i].opaque.has_value());
    if (object.opaque) {
      EXPECT_EQ(object.opaque->baseColor, scene.objects[i].opaque->baseColor);
    }
  }
}

// Numbers that override an object's own material, and a medium below its paint.
TEST_F(SceneWriter, NumbersOfMaterialsComeBack) {
  test::writeBytes(file(), R"(
model = "../../models/cubes.glb"
[materials.brass]
kind = "opaque"
metallic = 1
roughness = 0.25
[objects.plain]
material = "brass"
roughness = 0.75
base_color = [0.5, 0.25, 1]
[objects.")" + escaped(names[1]) +
                               "\"]\nroughness = 0.375\n");
  written(back());
  const LoadedScene loaded = back();
  ASSERT_TRUE(loaded.scene.objects[0].opaque && loaded.scene.objects[1].surface);
  EXPECT_EQ(loaded.scene.objects[0].opaque->metallic, 1);
  EXPECT_EQ(loaded.scene.objects[0].opaque->roughness, 0.75F);
  EXPECT_EQ(loaded.scene.objects[0].opaque->baseColor, (Rgb{0.5F, 0.25F, 1}));
  EXPECT_EQ(loaded.scene.objects[1].surface->roughness, 0.375F);
}

// A material's maps stay on a medium that replaces its own.
TEST_F(SceneWriter, TexturesStayOnAnotherMedium) {
  writePng(folder / "grey.png", {1, 1, {188, 188, 188, 255}});
  test::writeBytes(file(), R"(
model = "../../models/cubes.glb"
[materials.custom]
kind = "translucent"
color_texture = "../../grey.png"
mean_free_path_mm = [1, 2, 4]
roughness = 0.5
normal_texture = "../../grey.png"
[materials.brass]
kind = "opaque"
metallic = 1
normal_texture = "../../grey.png"
[objects.plain]
material = "brass"
base_color = [0.5, 0.25, 1]
[objects.")" + escaped(names[2]) +
                               "\"]\nmaterial = \"custom\"\n");
  LoadedScene edited = back();
  Medium other{"custom", {1, 2, 3}, {0.1, 0.2, 0.3}, 1.4};
  scene::putMedium(other, edited.scene.objects[0]);
  edited.scene.objects[2].medium = other;
  written(edited);
  const Scene scene = back().scene;
  EXPECT_FALSE(scene.objects[0].opaque);
  ASSERT_TRUE(scene.objects[0].surface && scene.objects[0].surface->normalTexture);
  EXPECT_EQ(scene.objects[0].medium.sigmaSPrimePerMm, other.sigmaSPrimePerMm);
  const Object& painted = scene.objects[2];
  EXPECT_EQ(painted.medium.sigmaSPrimePerMm, other.sigmaSPrimePerMm);
  ASSERT_TRUE(painted.paint && painted.paint->colorTexture);
  EXPECT_EQ(painted.paint->colorTexture->pixels->rgba[0], 188 * 257);
  ASSERT_TRUE(painted.surface && painted.surface->normalTexture);
  EXPECT_EQ(painted.surface->roughness, 0.5F);
}

// An OBJ file keeps its texture coordinates where a material of the scene needs them.
TEST_F(SceneWriter, TexturesOfTranslucentMaterialsArePaint) {
  writePng(folder / "grey.png", {1, 1, {188, 188, 188, 255}});
  test::writeBytes(folder / "tetra.obj",
                   "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0.25 0.75\n"
                   "f 1/1 3/1 2/1\nf 1/1 2/1 4/1\nf 1/1 4/1 3/1\nf 2/1 3/1 4/1\n");
  const auto loaded = [&](const std::string& materials) {
    test::writeBytes(file(), "model = \"../../tetra.obj\"\n" + materials);
    return back().scene.objects[0];
  };
  const Object painted = loaded(R"(
[materials.cheese]
kind = "translucent"
color = [1, 0.5, 0.25]
color_texture = "../../grey.png"
mean_free_path_mm = [1, 2, 4]
[objects.tetra]
material = "cheese"
)");
  ASSERT_TRUE(painted.paint && painted.paint->colorTexture);
  EXPECT_EQ(painted.paint->color, (Rgb{1, 0.5F, 0.25F}));
  ASSERT_EQ(painted.mesh.textureCoordinates[0].size(), painted.mesh.positionsMm.size());
  EXPECT_EQ(painted.mesh.textureCoordinates[0][0], (Vec2{0.25F, 0.25F}));
  // The whole texture is its brightest colour. 188 is half of the light.
  const Rgb bare = colorOf(painted.medium);
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(bare[c], 0.5026F * painted.paint->color[c], 1e-3F);
  const Object plain = loaded("medium = \"wax\"\n");
  EXPECT_FALSE(plain.paint);
  EXPECT_TRUE(plain.mesh.textureCoordinates[0].empty());
}

TEST_F(SceneWriter, MaterialsThatMakeNoSenseAreErrors) {
  const auto complaint = [&](const std::string& material) {
    test::writeBytes(file(),
                     "model = \"../../models/cubes.glb\"\n[materials.a]\n" + material + "\n");
    return test::messageOf([&] { back(); });
  };
  EXPECT_THAT(complaint("base_color = 1"), HasSubstr("no 'kind'"));
  EXPECT_THAT(complaint("kind = \"opaque\"\ncolor = 1"), HasSubstr("'color'"));
  EXPECT_THAT(complaint("kind = \"translucent\"\nmetallic = 1"), HasSubstr("'metallic'"));
  EXPECT_THAT(complaint("kind = \"translucent\""), HasSubstr("needs 'medium'"));
  EXPECT_THAT(complaint("kind = \"translucent\"\nmedium = \"marbel\""), HasSubstr("marbel"));
  EXPECT_THAT(complaint("kind = \"opaque\"\nnormal_texture = \"none.png\""), HasSubstr("none.png"));
  EXPECT_THAT(complaint("kind = \"opaque\"\nroughness = 2"), HasSubstr("roughness"));
}

}  // namespace
}  // namespace opaline
