#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "opaline/error.h"
#include "opaline/scene_file.h"
#include "scene/gltf/builder.h"
#include "scene/shapes.h"

namespace opaline {
namespace {

using testing::HasSubstr;

/// A scene of several models: cube.obj of edge 1, without a unit, and walker.glb. The latter is a
/// tetrahedron with a corner at (0,0,0) and legs of 1 m. It walks along x, with a point light 2 m
/// above that corner.
class Joined : public testing::Test {
 protected:
  Joined() {
    std::string cube;
    const scene::RawMesh mesh = test::cube();
    for (const Vec3& p : mesh.positions) {
      cube += "v " + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " +
              std::to_string(p[2]) + "\n";
    }
    for (const Triangle& t : mesh.triangles) {
      cube += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " +
              std::to_string(t[2] + 1) + "\n";
    }
    test::writeBytes(folder / "cube.obj", cube);
    test::GltfBuilder walker;
    const int positions = walker.vectors({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    const int corners =
        walker.add<std::uint16_t>({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, "SCALAR", 1);
    walker.meshes =
        fmt::format(R"({{"primitives":[{{"attributes":{{"POSITION":{}}},"indices":{}}}]}})",
                    positions, corners);
    walker.nodes = R"({"mesh":0,"name":"tetra"},)"
                   R"({"translation":[0,2,0],"extensions":{"KHR_lights_punctual":{"light":0}}})";
    walker.more =
        R"(,"extensionsUsed":["KHR_lights_punctual"],)"
        R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","intensity":1}]}})";
    const int times = walker.scalars({0, 1});
    const int places = walker.vectors({0, 0, 0, 0.5, 0, 0});
    walker.animate("walk", {test::GltfBuilder::sampler(times, places)},
                   {R"("node":0,"path":"translation")"});
    test::writeBytes(folder / "walker.glb", walker.file());
  }
  LoadedScene load(const std::string& text, const LoadOptions& options = {}) {
    test::writeBytes(folder / "a.toml", text);
    return loadSceneFile(folder / "a.toml", options);
  }
  std::string errorOf(const std::string& text) {
    return test::messageOf([&] { load(text); });
  }
  test::TemporaryFolder folder;
};

Bounds boundsOfObject(const Scene& scene, std::size_t object) {
  Scene alone;
  alone.objects.push_back(scene.objects.at(object));
  return boundsOf(alone);
}

void expectNear(const Vec3& a, const Vec3& b, double tolerance) {
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], tolerance);
}

// Edges of 10 and 20 mm; the second cube is turned from x to -z and moved.
TEST_F(Joined, EachModelStandsWhereItsTableSays) {
  const LoadedScene loaded = load(R"(
medium = "jade"
[[models]]
file = "cube.obj"
diagonal_mm = 17.320508
[[models]]
file = "cube.obj"
diagonal_mm = 17.320508
medium = "wholemilk"
scale = 2
rotation_degrees = [0, 90, 0]
translation_mm = [100, 0, 5]
)");
  ASSERT_EQ(loaded.scene.objects.size(), 2U);
  test::expectSound(loaded.scene);
  EXPECT_EQ(loaded.scene.objects[0].medium.name, "jade");
  EXPECT_EQ(loaded.scene.objects[1].medium.name, "wholemilk");
  EXPECT_EQ(loaded.scene.objects[1].name, loaded.scene.objects[0].name + " 2");
  expectNear(boundsOfObject(loaded.scene, 0).maxMm, {10, 10, 10}, 1e-4);
  expectNear(boundsOfObject(loaded.scene, 1).minMm, {100, 0, -15}, 1e-4);
  expectNear(boundsOfObject(loaded.scene, 1).maxMm, {120, 20, 5}, 1e-4);
}

// glTF is in metres. An OBJ without its own size gets 50 mm.
TEST_F(Joined, ManyOfOneNameAreNumberedAndTheirNotesSaidOnce) {
  std::string text = "[[models]]\nfile = 'cube.obj'\n";
  for (const std::string x : {"9", "18", "27"})
    text += "[[models]]\nfile = 'cube.obj'\ntranslation_mm = [" + x + ", 0, 0]\n";
  test::writeBytes(folder / "scene.toml", text);
  std::vector<std::string> notes;
  LoadOptions options;
  options.log = [&](LogLevel, std::string_view note) { notes.emplace_back(note); };
  const Scene scene = loadScene(folder / "scene.toml", options);
  ASSERT_EQ(scene.objects.size(), 4U);
  const std::string first = scene.objects[0].name;
  for (std::size_t i = 1; i < 4; ++i)
    EXPECT_EQ(scene.objects[i].name, first + " " + std::to_string(i + 1));
  EXPECT_EQ(notes.size(), 1U) << testing::PrintToString(notes);
}

TEST_F(Joined, FilesOfTheCommandLineKeepTheirUnits) {
  const LoadedScene loaded = loadSceneFiles({folder / "walker.glb", folder / "cube.obj"});
  ASSERT_EQ(loaded.scene.objects.size(), 2U);
  EXPECT_EQ(loaded.scene.name, "walker");
  expectNear(boundsOfObject(loaded.scene, 0).maxMm, {1000, 1000, 1000}, 1e-3);
  const float edge = 50 / std::sqrt(3.0F);
  expectNear(boundsOfObject(loaded.scene, 1).maxMm, {edge, edge, edge}, 1e-3);
}

TEST_F(Joined, ADiagonalIsThatOfAllTogetherAndIsWrittenSo) {
  LoadOptions options;
  options.diagonalMm = 100.0F;
  const LoadedScene loaded = loadSceneFiles({folder / "walker.glb", folder / "cube.obj"}, options);
  EXPECT_NEAR(diagonalMm(loaded.scene), 100, 1e-3);
  const double walker = diagonalMm({"", {loaded.scene.objects[0]}});
  const double cube = diagonalMm({"", {loaded.scene.objects[1]}});
  EXPECT_NEAR(walker / cube, 1000 * std::sqrt(3.0) / 50, 1e-4);

  writeScene(folder / "b.toml", describe(loaded.scene, loaded.source, {}));
  const LoadedScene again = loadSceneFile(folder / "b.toml");
  ASSERT_EQ(again.scene.objects.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(again.scene.objects[i].name, loaded.scene.objects[i].name);
    expectNear(boundsOfObject(again.scene, i).minMm, boundsOfObject(loaded.scene, i).minMm, 1e-4);
    expectNear(boundsOfObject(again.scene, i).maxMm, boundsOfObject(loaded.scene, i).maxMm, 1e-4);
  }
}

TEST_F(Joined, ClipsOfOneNamePlayTogetherAndLightsGoWithTheirModel) {
  const LoadedScene loaded = load(R"(
[[models]]
file = "walker.glb"
[[models]]
file = "walker.glb"
transform = [0.5, 0, 0, 3000,  0, 0.5, 0, 0,  0, 0, 0.5, 0,  0, 0, 0, 1]
)");
  test::expectSound(loaded.scene);
  ASSERT_EQ(loaded.scene.clips.size(), 1U);
  ASSERT_EQ(loaded.scene.clips[0].tracks.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_TRUE(loaded.scene.objects[i].rig);
    EXPECT_EQ(loaded.scene.clips[0].tracks[i].node, loaded.scene.objects[i].rig->node);
  }
  EXPECT_NE(loaded.scene.objects[0].rig->node, loaded.scene.objects[1].rig->node);
  const std::vector<PointLight>& lights = loaded.scene.lighting.points;
  ASSERT_EQ(lights.size(), 2U);
  expectNear(lights[0].positionMm, {0, 2000, 0}, 1e-2);
  expectNear(lights[1].positionMm, {3000, 1000, 0}, 1e-2);
  // Half as far and a quarter as strong, a light is as bright on the smaller body.
  EXPECT_NEAR(lights[1].intensity[0], lights[0].intensity[0] / 4, 1e-5 * lights[0].intensity[0]);
}

TEST_F(Joined, WhatIsWrittenIsTheSame) {
  const LoadedScene loaded = load(R"(
[[models]]
file = "walker.glb"
rotation_degrees = [10, 20, 30]
[[models]]
file = "cube.obj"
diagonal_mm = 700
medium = "jade"
translation_mm = [0, -800, 0]
[[models]]
file = "builtin:teapot"
scale = 3
)");
  writeScene(folder / "b.toml", describe(loaded.scene, loaded.source, {}));
  const LoadedScene again = loadSceneFile(folder / "b.toml");
  ASSERT_EQ(again.scene.objects.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(again.scene.objects[i].mesh.positionsMm, loaded.scene.objects[i].mesh.positionsMm);
    EXPECT_EQ(again.scene.objects[i].medium.name, loaded.scene.objects[i].medium.name);
  }
}

TEST_F(Joined, WhatCannotBeJoinedIsRefused) {
  const std::string two = "[[models]]\nfile = 'cube.obj'\n[[models]]\nfile = 'cube.obj'\n";
  EXPECT_THAT(errorOf("model = 'cube.obj'\n" + two), HasSubstr("[[models]]"));
  EXPECT_THAT(errorOf("diagonal_mm = 3\n" + two), HasSubstr("diagonal_mm"));
  EXPECT_THAT(errorOf(two + "scal = 2\n"), HasSubstr("scale"));
  EXPECT_THAT(errorOf(two + "[[models]]\nscale = 2\n"), HasSubstr("file"));
  EXPECT_THAT(errorOf(two + "[[models]]\nfile = 'a.toml'\n"), HasSubstr("another .toml"));
  EXPECT_THAT(errorOf(two + "[[models]]\nfile = 'm_%d.ply'\n"), HasSubstr("only model"));
  EXPECT_THAT(errorOf(two + "transform = [0,0,0,0, 0,0,0,0, 0,0,0,0, 0,0,0,1]\n"),
              HasSubstr("flattens"));
  EXPECT_THAT(test::messageOf([&] {
                loadSceneFiles({folder / "cube.obj", folder / "a.toml"});
              }),
              HasSubstr("[[models]]"));
  EXPECT_THAT(test::messageOf([&] {
                loadSceneFiles({folder / "cube.obj", folder / "m_%d.ply"});
              }),
              HasSubstr("only model"));
  EXPECT_THAT(test::messageOf([] { loadSceneFiles({}); }), HasSubstr("at least one file"));
}

}  // namespace
}  // namespace opaline
