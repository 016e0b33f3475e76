#include "scene/repair/duplicate_objects.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "opaline/media.h"
#include "opaline/scene_file.h"
#include "scene/shapes.h"

namespace opaline::scene {
namespace {

Object cubeAt(const std::string& name, const Vec3& at) {
  const RawMesh mesh = test::cube(at);
  return {.name = name,
          .mesh = {.positionsMm = mesh.positions, .triangles = mesh.triangles},
          .medium = findMedium("marble").value()};
}

std::string namesOf(const Scene& scene) {
  std::string names;
  for (const Object& object : scene.objects) names += object.name;
  return names;
}

/// A scene file of three tetrahedra, two of them at one place.
LoadedScene loadTetrahedra(const test::TemporaryFolder& folder) {
  test::writeBytes(folder / "tetrahedron.obj",
                   "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const std::string model = "[[models]]\nfile = 'tetrahedron.obj'\n";
  test::writeBytes(folder / "scene.toml", model + model + model + "translation_mm = [90, 0, 0]\n");
  return loadSceneFile(folder / "scene.toml");
}

TEST(DuplicateObjects, OfOnePlaceShapeAndMaterialAreOne) {
  Scene scene;
  for (const char* name : {"a", "b", "c"}) scene.objects.push_back(cubeAt(name, {1, 2, 3}));
  scene.objects.insert(scene.objects.begin() + 1, cubeAt("beside", {2, 2, 3}));
  EXPECT_EQ(removeDuplicateObjects(scene), 2U);
  EXPECT_EQ(namesOf(scene), "abeside");
  EXPECT_EQ(removeDuplicateObjects(scene), 0U);
}

TEST(DuplicateObjects, AreNotThoseOfAnotherMaterialOrShape) {
  Scene scene;
  scene.objects = {cubeAt("a", {0, 0, 0}), cubeAt("b", {0, 0, 0}), cubeAt("c", {0, 0, 0})};
  scene.objects[1].medium = findMedium("skin1").value();
  scene.objects[2].mesh.triangles.pop_back();
  EXPECT_EQ(removeDuplicateObjects(scene), 0U);
}

TEST(DuplicateObjects, MayBeOfALaterObject) {
  Scene scene;
  scene.objects = {cubeAt("a", {0, 0, 0}), cubeAt("b", {0, 0, 0}), cubeAt("c", {0, 0, 0})};
  scene.objects[1].medium = scene.objects[2].medium = findMedium("skin1").value();
  EXPECT_EQ(removeDuplicateObjects(scene), 1U);
  EXPECT_EQ(namesOf(scene), "ab");
  EXPECT_EQ(scene.objects[1].duplicates, std::vector<std::string>{"c"});
}

TEST(DuplicateObjects, AreNotThoseThatMoveOrChange) {
  Scene scene;
  scene.objects = {cubeAt("a", {0, 0, 0}), cubeAt("b", {0, 0, 0}), cubeAt("c", {0, 0, 0})};
  scene.objects[1].rig.emplace();
  scene.changes.emplace_back().media.push_back({2, {0}, {findMedium("skin1").value()}});
  EXPECT_EQ(removeDuplicateObjects(scene), 0U);
}

TEST(DuplicateObjects, LeaveChangesToTheObjectsThatTheyWereOf) {
  Scene scene;
  scene.objects = {cubeAt("a", {0, 0, 0}), cubeAt("b", {0, 0, 0}), cubeAt("c", {5, 0, 0})};
  scene.changes.emplace_back().media.push_back({2, {0}, {findMedium("skin1").value()}});
  EXPECT_EQ(removeDuplicateObjects(scene), 1U);
  EXPECT_EQ(namesOf(scene), "ac");
  EXPECT_EQ(scene.changes[0].media[0].index, 1U);
}

TEST(DuplicateObjects, OfASceneFileAreARepair) {
  const test::TemporaryFolder folder;
  const Scene scene = loadTetrahedra(folder).scene;
  EXPECT_EQ(scene.objects.size(), 2U);
  EXPECT_EQ(test::countOf(scene.repairs, "duplicate objects"), 1U);
}

TEST(DuplicateObjects, AreStillDuplicatesOnceTheSceneWasSaved) {
  const test::TemporaryFolder folder;
  LoadedScene loaded = loadTetrahedra(folder);
  loaded.scene.objects.at(0).medium = findMedium("skin1").value();
  const auto saved =
      writeScene({folder / "saved.toml"}, describe(loaded.scene, loaded.source, loaded.settings));
  const Scene again = loadSceneFile(saved).scene;
  ASSERT_EQ(again.objects.size(), 2U);
  EXPECT_EQ(again.objects[0].medium.name, "skin1");
  EXPECT_EQ(again.objects[0].duplicates, loaded.scene.objects[0].duplicates);
  EXPECT_EQ(again.objects[1].medium.name, "marble");
}

}  // namespace
}  // namespace opaline::scene
