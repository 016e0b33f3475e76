#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <optional>
#include <sstream>

#include "opaline/error.h"
#include "opaline/mesh.h"
#include "opaline/scene.h"
#include "scene/shapes.h"
#include "shared_files.h"

namespace opaline {
namespace {

struct Expected {
  const char* file;
  std::size_t triangles;
  std::size_t vertices;
  std::optional<MeshFacts> facts;
  std::size_t duplicates = 0;  ///< vertices of the file that equal another in every attribute
};

// Counts and topology from the models' own README.
const Expected expected[] = {
    {"teapot.ply", 2256, 1177, {{false, 6, 3}}},
    {"teapot.obj", 2256, 1177, {{false, 6, 3}}},
    {"teapot_split.ply", 2256, 1178, {{false, 6, 4}}},
    {"buddha.ply", 50000, 24978, {{true, 0, 1}}},
    {"max_planck.ply", 50801, 25445, {{false, 1, 1}}},
    {"bunny.ply", 69451, 34834, {{false, 5, 1}}},
    {"bunny_closed.ply", 70312, 35158, {{true, 0, 1}}},
    {"bunny_egg_a.ply", 50236, 25120, {{true, 0, 1}}},
    {"bunny_egg_b.ply", 50236, 25120, {{true, 0, 1}}},
    {"gltf/AnimatedMorphCube.glb", 12, 24, {}},
    {"gltf/AnimatedMorphSphere.glb", 960, 1876, {}},
    {"gltf/SimpleMorph.gltf", 1, 3, {}},
    {"gltf/SimpleSparseAccessor.gltf", 12, 36, {}},  // flat: no normals
    {"gltf/SimpleSkin.gltf", 8, 24, {}},             // flat: no normals
    {"gltf/RiggedSimple.glb", 188, 96, {}},
    {"gltf/RiggedFigure.glb", 256, 365, {}, 5},
    {"gltf/CesiumMan.glb", 4672, 3273, {}},
    {"gltf/Fox.glb", 576, 1728, {}},
    {"gltf/MorphStressTest.gltf", 2412, 1528, {}},
    {"gltf/greenman.glb", 356, 196, {}},
    {"gltf/BunnyEgg.glb", 50236, 25120, {{true, 0, 1}}},
    {"gltf/TranslucentTrio.glb", 6768, 3534, {{false, 18, 12}}},
};

class Models : public testing::TestWithParam<Expected> {};

TEST_P(Models, HaveTheCountsOfTheirReadme) {
  const auto folder = test::modelsFolder();
  if (!folder) GTEST_SKIP() << "the shared models are not here; set OPALINE_MODELS to their folder";
  const Expected& of = GetParam();
  const Scene loaded = loadScene(*folder / of.file);
  test::expectSound(loaded);
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  for (const Object& object : loaded.objects) {
    triangles += object.mesh.triangles.size();
    vertices += object.mesh.positionsMm.size();
  }
  EXPECT_EQ(triangles, of.triangles);
  EXPECT_EQ(vertices, of.vertices);
  EXPECT_EQ(test::countOf(loaded.repairs, "duplicate vertices"), of.duplicates);
  for (const Repair& repair : loaded.repairs) {
    if (repair.what == "duplicate vertices") continue;
    ADD_FAILURE() << "a clean file was repaired: " << repair.count << " " << repair.what;
  }
  if (!of.facts) return;
  MeshFacts sum{.closed = true};
  for (const Object& object : loaded.objects) {
    const MeshFacts facts = factsOf(object.mesh.positionsMm, object.mesh.triangles);
    sum.closed = sum.closed && facts.closed;
    sum.boundaryLoops += facts.boundaryLoops;
    sum.components += facts.components;
  }
  EXPECT_EQ(sum.closed, of.facts->closed);
  EXPECT_EQ(sum.boundaryLoops, of.facts->boundaryLoops);
  EXPECT_EQ(sum.components, of.facts->components);
}

INSTANTIATE_TEST_SUITE_P(All, Models, testing::ValuesIn(expected), [](const auto& of) {
  std::string name(of.param.file);
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
});

TEST(SharedModels, TrioHasTheMeasuredMedia) {
  const auto folder = test::modelsFolder();
  if (!folder) GTEST_SKIP() << "the shared models are not here; set OPALINE_MODELS to their folder";
  const Scene trio = loadScene(*folder / "gltf/TranslucentTrio.glb");
  ASSERT_EQ(trio.objects.size(), 3U);
  // Jensen et al. 2001, Figure 5.
  EXPECT_EQ(trio.objects[0].medium.name, "marble");
  EXPECT_DOUBLE_EQ(trio.objects[0].medium.sigmaSPrimePerMm[0], 2.19);
  EXPECT_DOUBLE_EQ(trio.objects[0].medium.eta, 1.5);
  EXPECT_DOUBLE_EQ(trio.objects[1].medium.sigmaAPerMm[1], 0.17);
  EXPECT_DOUBLE_EQ(trio.objects[2].medium.sigmaAPerMm[2], 1.45);
  EXPECT_DOUBLE_EQ(trio.objects[2].medium.eta, 1.3);
  // Each teapot is 6.43 units of 10 mm wide, 90 mm apart.
  const Bounds bounds = boundsOf(trio);
  EXPECT_NEAR(bounds.maxMm[0] - bounds.minMm[0], 180 + 64.3, 0.1);
}

TEST(SharedModels, TurnedInsideOutAreTurnedBack) {
  const auto folder = test::modelsFolder();
  if (!folder) GTEST_SKIP() << "the shared models are not here; set OPALINE_MODELS to their folder";
  const test::TemporaryFolder temporary;
  for (const char* name : {"teapot.obj"}) {
    std::string text = test::readBytes(*folder / name);
    std::string turned;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string keyword, a, b, c;
      words >> keyword >> a >> b >> c;
      turned += keyword == "f" ? fmt::format("f {} {} {}\n", a, c, b) : line + "\n";
    }
    test::writeBytes(temporary / "turned.obj", turned);
    const Scene straight = loadScene(*folder / name);
    const Scene mended = loadScene(temporary / "turned.obj");
    EXPECT_EQ(test::countOf(mended.repairs, "inward orientation"), 2256U);
    // The order of vertices may differ.
    std::map<Vec3, Vec3> normalAt;
    const Mesh& mesh = straight.objects[0].mesh;
    for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
      normalAt[mesh.positionsMm[v]] = mesh.normals[v];
    }
    for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
      const auto known = normalAt.find(mended.objects[0].mesh.positionsMm[v]);
      ASSERT_NE(known, normalAt.end());
      const Vec3& a = known->second;
      const Vec3& b = mended.objects[0].mesh.normals[v];
      ASSERT_GT(a[0] * b[0] + a[1] * b[1] + a[2] * b[2], 0.999F);
    }
  }
}

}  // namespace
}  // namespace opaline
