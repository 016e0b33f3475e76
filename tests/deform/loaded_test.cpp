#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "allocations.h"
#include "core/temporary_folder.h"
#include "deform/deformed_vertices.h"
#include "opaline/error.h"
#include "scene/gltf/builder.h"

// Generated files, from their bytes to the posed vertices.

namespace opaline::deform {
namespace {

using scene::Double3;
using scene::operator+;
using scene::operator-;
using scene::operator*;
using test::GltfBuilder;

Scene loadBuilt(const GltfBuilder& builder) {
  const test::TemporaryFolder folder;
  test::writeBytes(folder / "a.glb", builder.file());
  return loadScene(folder / "a.glb");
}

/// A tetrahedron with normals. Mesh 0 is bare, mesh 1 is skinned by its node's skin, mesh 2 has
/// morph targets and a skin. Vertices 0, 1, 2 follow joint 0, vertex 3 follows joint 1.
struct Tetrahedra {
  GltfBuilder b;
  int times = 0;

  Tetrahedra() {
    const int position = b.vectors({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    const int normal = b.vectors({-1, -1, -1, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    const int index = b.add<std::uint16_t>({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, "SCALAR", 1);
    const int joints =
        b.add<std::uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4);
    const int weights =
        b.add<std::uint8_t>({255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0}, "VEC4", 4,
                            R"(,"normalized":true)");
    const int offset = b.vectors({0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1});
    const std::string bare = fmt::format(R"("POSITION":{},"NORMAL":{})", position, normal);
    const std::string skinned =
        bare + fmt::format(R"(,"JOINTS_0":{},"WEIGHTS_0":{})", joints, weights);
    const std::string targets = fmt::format(R"(,"targets":[{{"POSITION":{}}}])", offset);
    b.meshes = fmt::format(R"({{"primitives":[{{"attributes":{{{0}}},"indices":{2}}}]}},)"
                           R"({{"primitives":[{{"attributes":{{{1}}},"indices":{2}}}]}},)"
                           R"({{"primitives":[{{"attributes":{{{1}}},"indices":{2}{3}}}]}})",
                           bare, skinned, index, targets);
    times = b.scalars({0, 1});
  }
};

double volumeOf(const Mesh& mesh, const DeformedVertices& deformed) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    sum += scene::dot(deformed.positionsMm[t[0]],
                      scene::cross(deformed.positionsMm[t[1]], deformed.positionsMm[t[2]]));
  }
  return sum / 6;
}

Double3 middleOf(const DeformedVertices& mesh) {
  Double3 sum{};
  for (const Double3& p : mesh.positionsMm) sum = sum + p;
  return (1 / static_cast<double>(mesh.positionsMm.size())) * sum;
}

TEST(LoadedMotion, MirroredInstancesStayRightSideOut) {
  Tetrahedra of;
  of.b.nodes = R"({"mesh":0},{"mesh":0,"scale":[-2,1,1]},{"children":[0,1]})";
  of.b.animate("turn",
               {GltfBuilder::sampler(of.times, of.b.quaternions({0, 0, 0, 1, 0, 0.6F, 0, 0.8F}))},
               {R"("node":2,"path":"rotation")"});
  const Scene scene = loadBuilt(of.b);
  ASSERT_EQ(scene.objects.size(), 2U);
  for (std::size_t o = 0; o < 2; ++o) {
    const DeformedVertices mesh = deformedVertices(scene, o, 0, 0.7);
    EXPECT_NEAR(volumeOf(scene.objects[o].mesh, mesh), (o == 0 ? 1e9 : 2e9) / 6, 1e3);
    for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
      EXPECT_GT(scene::dot(mesh.normals[v], mesh.positionsMm[v] - middleOf(mesh)), 0);
    }
  }
}

TEST(LoadedMotion, TwoSkinsOfOneMeshMoveApart) {
  Tetrahedra of;
  of.b.nodes = R"({"mesh":1,"skin":0,"translation":[50,0,0]},{"mesh":1,"skin":1},)"
               R"({"name":"a"},{"name":"b"},{"name":"c","translation":[0,0,10]})";
  of.b.more = R"(,"skins":[{"joints":[2,3]},{"joints":[4,3]}])";
  of.b.animate("go", {GltfBuilder::sampler(of.times, of.b.vectors({0, 0, 0, 0, 4, 0}))},
               {R"("node":3,"path":"translation")"});
  const Scene scene = loadBuilt(of.b);
  ASSERT_EQ(scene.objects.size(), 2U);
  for (std::size_t o = 0; o < 2; ++o) {
    const DeformedVertices mesh = deformedVertices(scene, o, 0, 0.5);
    for (std::size_t v = 0; v < 4; ++v) {
      const Double3 from = scene::toDouble(scene.objects[o].rig->positions[v]);
      const bool tip = from[2] == 1;
      // Joint b lifts the tip by 2 m. The rest stays with a, or with c, which is 10 m away.
      const Double3 expected = from + (tip ? Double3{0, 2, 0} : Double3{0, 0, o == 0 ? 0.0 : 10.0});
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(mesh.positionsMm[v][axis], 1000 * expected[axis], 1e-3);
      }
    }
  }
}

TEST(LoadedMotion, SkinAndMorphOfOneMesh) {
  Tetrahedra of;
  of.b.nodes = R"({"mesh":2,"skin":0},{"name":"a"},{"name":"b"})";
  of.b.more = R"(,"skins":[{"joints":[1,2]}])";
  of.b.animate("both",
               {GltfBuilder::sampler(of.times, of.b.scalars({0, 1})),
                GltfBuilder::sampler(of.times, of.b.vectors({1, 1, 1, 3, 3, 3}))},
               {R"("node":0,"path":"weights")", R"("node":2,"path":"scale")"});
  const Scene scene = loadBuilt(of.b);
  const DeformedVertices mesh = deformedVertices(scene, 0, 0, 0.5);
  for (std::size_t v = 0; v < 4; ++v) {
    const Vec3& from = scene.objects[0].rig->positions[v];
    // Half of the offsets, then twice for the tip.
    Double3 expected = scene::toDouble(from);
    if (from[0] == 1) expected = {1.5, 0, 0};
    if (from[2] == 1) expected = {0, 0, 3};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(mesh.positionsMm[v][axis], 1000 * expected[axis], 1e-3);
    }
  }
}

/// Whatever loads must be posable at any time. The seed is fixed.
TEST(LoadedMotion, DamagedFilesThatLoadCanBePosed) {
  Tetrahedra of;
  of.b.nodes = R"({"mesh":2,"skin":0},{"children":[2]},{"name":"b"},{"mesh":0,"scale":[1,2,3]})";
  of.b.more = R"(,"skins":[{"joints":[1,2]}])";
  of.b.animate("all",
               {GltfBuilder::sampler(of.times, of.b.scalars({0, 0, 1, 1, 0, 0}), "CUBICSPLINE"),
                GltfBuilder::sampler(of.times, of.b.quaternions({0, 0, 0, 1, 1, 0, 0, 0})),
                GltfBuilder::sampler(of.times, of.b.vectors({0, 0, 0, 1, 2, 3}), "STEP")},
               {R"("node":0,"path":"weights")", R"("node":1,"path":"rotation")",
                R"("node":3,"path":"translation")"});
  const std::string whole = of.b.file();
  const test::TemporaryFolder folder;
  std::mt19937 random(20081213);
  int loaded = 0;
  for (int i = 0; i < 400; ++i) {
    std::string bytes = whole;
    for (unsigned change = 0; change <= random() % 3; ++change) {
      const std::size_t at = 20 + random() % (bytes.size() - 20);
      // Digits replace digits, so that the JSON often stays valid.
      const bool digit = bytes[at] >= '0' && bytes[at] <= '9';
      bytes[at] = static_cast<char>(digit ? '0' + random() % 10 : random() % 256);
    }
    test::writeBytes(folder / "a.glb", bytes);
    try {
      const Scene scene = loadScene(folder / "a.glb");
      ++loaded;
      for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        for (const double seconds : {0.0, 0.3, 1.0, 1e9, -1.0, 1e300}) {
          const DeformedVertices mesh = deformedVertices(scene, o, 0, seconds);
          ASSERT_EQ(mesh.positionsMm.size(), scene.objects[o].mesh.positionsMm.size());
          for (const Double3& n : mesh.normals) ASSERT_TRUE(scene::isFinite(n));
        }
      }
    } catch (const Error& error) {
      ASSERT_NE(std::string(error.what()), "");
    }
  }
  EXPECT_GT(loaded, 20);
}

TEST(LoadedMotion, PosesAllocateNothing) {
  Tetrahedra of;
  of.b.nodes = R"({"mesh":2,"skin":0},{"name":"a"},{"name":"b"})";
  of.b.more = R"(,"skins":[{"joints":[1,2]}])";
  of.b.animate("both",
               {GltfBuilder::sampler(of.times, of.b.scalars({0, 1})),
                GltfBuilder::sampler(of.times, of.b.quaternions({0, 0, 0, 1, 1, 0, 0, 0}))},
               {R"("node":0,"path":"weights")", R"("node":2,"path":"rotation")"});
  const Scene scene = loadBuilt(of.b);
  const Rig& rig = *scene.objects[0].rig;
  scene::Pose pose = scene::makePose(scene);
  std::vector<scene::Matrix4> matrices(rig.joints.size());
  float sum = 0;
  const std::size_t before = test::allocations();
  for (int frame = 0; frame < 100; ++frame) {
    poseAt(scene, 0, frame / 30.0, pose);
    jointMatrices(rig, pose, matrices);
    sum += morphWeights(rig, pose)[0];
  }
  EXPECT_EQ(test::allocations(), before);
  EXPECT_GT(sum, 0);
}

}  // namespace
}  // namespace opaline::deform
