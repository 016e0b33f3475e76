#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "opaline/error.h"
#include "opaline/scene.h"
#include "scene/gltf/builder.h"
#include "scene/gltf/gltf_fixture.h"
#include "scene/shapes.h"

namespace opaline {
namespace {

using testing::ElementsAre;
using testing::FloatNear;
using testing::HasSubstr;

using test::GltfBuilder;
using test::tetrahedronFaces;

const std::vector<float> tetrahedronCorners{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};

class GltfAnimation : public testing::Test {
 protected:
  GltfAnimation() {
    position = b.vectors(tetrahedronCorners);
    index = b.add(tetrahedronFaces, "SCALAR", 1);
    // Roughly outwards from the middle.
    normal = b.vectors({-1, -1, -1, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    mesh("");
    times = b.scalars({0, 2});
  }
  /// A mesh with normals; `more` adds attributes, `tail` members beside them.
  void mesh(const std::string& attributes, const std::string& tail = "") {
    b.meshes = fmt::format(
        R"({{"primitives":[{{"attributes":{{"POSITION":{},"NORMAL":{}{}}},"indices":{}{}}}]}})",
        position, normal, attributes, index, tail);
  }
  void flatMesh(const std::string& tail = "") {
    b.meshes =
        fmt::format(R"({{"primitives":[{{"attributes":{{"POSITION":{}}},"indices":{}{}}}]}})",
                    position, index, tail);
  }
  void moveNode(int node) {
    b.animate("go", {GltfBuilder::sampler(times, b.vectors({0, 0, 0, 1, 2, 3}))},
              {fmt::format(R"("node":{},"path":"translation")", node)});
  }
  Scene load() {
    test::writeBytes(folder / "a.glb", b.file());
    LoadOptions options;
    options.log = [&](LogLevel, std::string_view message) { notes.emplace_back(message); };
    return loadScene(folder / "a.glb", options);
  }
  std::string error() {
    const std::string message = test::messageOf([&] { load(); });
    EXPECT_THAT(message, HasSubstr("a.glb"));
    EXPECT_LT(message.size(), 300U);
    return message;
  }
  GltfBuilder b;
  int position = 0;
  int index = 0;
  int normal = 0;
  int times = 0;
  test::TemporaryFolder folder;
  std::vector<std::string> notes;
};

TEST_F(GltfAnimation, ClipsHaveTheTracksOfTheFile) {
  b.nodes = R"({"mesh":0,"name":"tetra","children":[1]},{"name":"hand"})";
  b.animate("wave",
            {GltfBuilder::sampler(times, b.quaternions({0, 0, 0, 1, 0, 0, 1, 0}), "STEP"),
             GltfBuilder::sampler(b.scalars({1, 5}),
                                  b.vectors({1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 5, 5, 5, 6, 6, 6}),
                                  "CUBICSPLINE")},
            {R"("node":0,"path":"rotation")", R"("node":1,"path":"scale")"});
  moveNode(0);
  const Scene scene = load();
  ASSERT_EQ(scene.nodes.size(), 2U);
  EXPECT_EQ(scene.nodes[1].name, "hand");
  EXPECT_EQ(scene.nodes[1].parent, 0);
  ASSERT_EQ(scene.clips.size(), 2U);
  EXPECT_EQ(scene.clips[0].name, "wave");
  EXPECT_EQ(scene.clips[0].seconds, 5);
  EXPECT_EQ(scene.clips[1].seconds, 2);
  ASSERT_EQ(scene.clips[0].tracks.size(), 2U);
  const Track& turn = scene.clips[0].tracks[0];
  EXPECT_EQ(turn.target, TrackTarget::Rotation);
  EXPECT_EQ(turn.interpolation, Interpolation::Step);
  EXPECT_THAT(turn.values, ElementsAre(0, 0, 0, 1, 0, 0, 1, 0));
  const Track& scale = scene.clips[0].tracks[1];
  EXPECT_EQ(scale.node, 1U);
  EXPECT_EQ(scale.interpolation, Interpolation::CubicSpline);
  EXPECT_THAT(scale.seconds, ElementsAre(1, 5));
  EXPECT_EQ(scale.values.size(), 18U);
  ASSERT_TRUE(scene.objects[0].rig);
  EXPECT_EQ(scene.objects[0].rig->node, 0U);
  EXPECT_TRUE(scene.objects[0].rig->targets.empty());
  EXPECT_FLOAT_EQ(scene.objects[0].rig->toScene.columns[1][1], 1000);
}

TEST_F(GltfAnimation, ParentsComeFirst) {
  b.nodes =
      R"({"mesh":0},{"name":"mid","children":[0]},{"name":"top","children":[1],"scale":[2,2,2]})";
  moveNode(1);
  const Scene scene = load();
  ASSERT_EQ(scene.nodes.size(), 3U);
  EXPECT_EQ(scene.nodes[0].name, "top");
  EXPECT_EQ(scene.nodes[1].name, "mid");
  EXPECT_EQ(scene.nodes[1].parent, 0);
  EXPECT_EQ(scene.nodes[2].parent, 1);
  EXPECT_EQ(scene.clips[0].tracks[0].node, 1U);
  ASSERT_TRUE(scene.objects[0].rig);  // one of its ancestors moves
  EXPECT_EQ(scene.objects[0].rig->node, 2U);
}

TEST_F(GltfAnimation, WhatNoClipMovesHasNoRig) {
  b.nodes = R"({"mesh":0},{"name":"beside"})";
  moveNode(1);
  const Scene scene = load();
  EXPECT_EQ(scene.clips.size(), 1U);
  EXPECT_FALSE(scene.objects[0].rig);
}

TEST_F(GltfAnimation, NormalisedIntegersAreRotations) {
  b.animate("turn",
            {GltfBuilder::sampler(times, b.add<std::int16_t>({0, 0, 0, 32767, 0, 0, -32768, 0},
                                                             "VEC4", 4, R"(,"normalized":true)")),
             GltfBuilder::sampler(times, b.add<std::int8_t>({0, 0, 0, 127, 0, 0, -128, 0}, "VEC4",
                                                            4, R"(,"normalized":true)"))},
            {R"("node":0,"path":"rotation")", R"("node":0,"path":"rotation")"});
  const Scene scene = load();
  for (const Track& track : scene.clips[0].tracks) {
    EXPECT_THAT(track.values, ElementsAre(0, 0, 0, 1, 0, 0, -1, 0));
  }
}

TEST_F(GltfAnimation, WeightsAreNormalisedIntegersToo) {
  mesh("",
       fmt::format(R"(,"targets":[{{"POSITION":{0}}},{{"POSITION":{0},"NORMAL":{0}}}])", position));
  b.animate("swell",
            {GltfBuilder::sampler(times, b.add<std::uint8_t>({0, 255, 51, 102}, "SCALAR", 1,
                                                             R"(,"normalized":true)"))},
            {R"("node":0,"path":"weights")"});
  const Scene scene = load();
  const Track& track = scene.clips[0].tracks[0];
  EXPECT_THAT(track.values, ElementsAre(FloatNear(0, 1e-6F), FloatNear(1, 1e-6F),
                                        FloatNear(0.2F, 1e-6F), FloatNear(0.4F, 1e-6F)));
  const Rig& rig = *scene.objects[0].rig;
  ASSERT_EQ(rig.targets.size(), 2U);
  EXPECT_TRUE(rig.targets[0].normals.empty());
  EXPECT_EQ(rig.targets[1].normals.size(), 4U);
}

/// Sparse: all four offsets are zero except the third.
TEST_F(GltfAnimation, TargetsMayBeSparse) {
  const int places = b.add<std::uint16_t>({2}, "SCALAR", 1);
  const int values = b.vectors({7, 8, 9});
  b.accessors.push_back(fmt::format(
      R"({{"componentType":5126,"count":4,"type":"VEC3","sparse":{{"count":1,"indices":)"
      R"({{"bufferView":{},"componentType":5123}},"values":{{"bufferView":{}}}}}}})",
      places, values));
  mesh("", fmt::format(R"(,"targets":[{{"POSITION":{}}}])", b.accessors.size() - 1));
  b.animate("swell", {GltfBuilder::sampler(times, b.scalars({0, 1}))},
            {R"("node":0,"path":"weights")"});
  const Rig rig = *load().objects[0].rig;
  for (std::size_t v = 0; v < 4; ++v) {
    const bool third = rig.positions[v] == Vec3{0, 1, 0};
    EXPECT_EQ(rig.targets[0].positions[v], (third ? Vec3{7, 8, 9} : Vec3{0, 0, 0}));
  }
}

TEST_F(GltfAnimation, SkinsKeepJointsAndSumTheirWeightsToOne) {
  // Two sets of influences, of 8 and of 16 bits. The mesh's own node is far away.
  const int joints0 =
      b.add<std::uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0}, "VEC4", 4);
  const int weights0 = b.add<std::uint8_t>({255, 0, 0, 0, 51, 0, 0, 0, 51, 51, 0, 0, 0, 0, 0, 0},
                                           "VEC4", 4, R"(,"normalized":true)");
  const int joints1 =
      b.add<std::uint16_t>({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 9, 9, 9}, "VEC4", 4);
  const int weights1 = b.add<std::uint16_t>({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 13107, 0, 0, 0},
                                            "VEC4", 4, R"(,"normalized":true)");
  mesh(fmt::format(R"(,"JOINTS_0":{},"WEIGHTS_0":{},"JOINTS_1":{},"WEIGHTS_1":{})", joints0,
                   weights0, joints1, weights1));
  const int inverse = b.add<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1,  //
                                    1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -5, 0, 0, 1},
                                   "MAT4", 16);
  b.nodes = R"({"mesh":0,"skin":0,"translation":[100,0,0]},{"name":"j0"},)"
            R"({"name":"j1","translation":[5,0,0]})";
  b.more = fmt::format(R"(,"skins":[{{"joints":[1,2],"inverseBindMatrices":{}}}])", inverse);
  moveNode(2);
  const Scene scene = load();
  EXPECT_NEAR(boundsOf(scene).maxMm[0], 1000, 1e-3);
  const Rig& rig = *scene.objects[0].rig;
  ASSERT_EQ(rig.joints.size(), 2U);
  EXPECT_EQ(rig.joints[1].inverseBind.columns[3], (Vec3{-5, 0, 0}));
  ASSERT_EQ(rig.firstInfluence.size(), 5U);
  for (std::size_t v = 0; v < 4; ++v) {
    double sum = 0;
    for (std::size_t i = rig.firstInfluence[v]; i < rig.firstInfluence[v + 1]; ++i) {
      sum += double{rig.influences[i].weight};
    }
    EXPECT_NEAR(sum, 1, 1e-6);
    const std::size_t count = rig.firstInfluence[v + 1] - rig.firstInfluence[v];
    const bool shared = rig.positions[v] == Vec3{0, 1, 0};
    const bool ofFirst = shared || rig.positions[v] == Vec3{0, 0, 0};
    EXPECT_EQ(count, shared ? 2U : 1U);
    EXPECT_EQ(rig.influences[rig.firstInfluence[v]].joint, ofFirst ? 0U : 1U);
  }
}

TEST_F(GltfAnimation, WithoutNormalsTheMeshIsFacetted) {
  flatMesh();
  moveNode(0);
  const Scene scene = load();
  test::expectSound(scene);
  const Object& object = scene.objects[0];
  EXPECT_TRUE(object.mesh.facetted);
  ASSERT_EQ(object.rig->positions.size(), 12U);
  for (std::size_t v = 0; v < 12; ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_FLOAT_EQ(1000 * object.rig->positions[v][axis], object.mesh.positionsMm[v][axis]);
      EXPECT_NEAR(object.rig->normals[v][axis], object.mesh.normals[v][axis], 1e-6F);
    }
  }
}

/// Unused, duplicate and inside-out parts are repaired; the rig follows every step.
TEST_F(GltfAnimation, RigsFollowRepairs) {
  // Vertices: an unused one, then two copies of the tetrahedron's, all faces inside out.
  std::vector<float> positions{9, 9, 9};
  std::vector<float> normals{0, 0, 1};
  const std::vector<float> out{-1, -1, -1, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  for (int copy = 0; copy < 2; ++copy) {
    positions.insert(positions.end(), tetrahedronCorners.begin(), tetrahedronCorners.end());
    for (const float n : out) normals.push_back(-n);
  }
  position = b.vectors(positions);
  normal = b.vectors(normals);
  index = b.add<std::uint16_t>({1, 2, 3, 1, 8, 2, 1, 3, 4, 6, 8, 7}, "SCALAR", 1);
  std::vector<float> offsets;
  for (std::size_t i = 0; i < positions.size(); ++i) offsets.push_back(10 * positions[i]);
  const int offset = b.vectors(offsets);
  mesh("", fmt::format(R"(,"targets":[{{"POSITION":{},"NORMAL":{}}}])", offset, normal));
  b.animate("swell", {GltfBuilder::sampler(times, b.scalars({0, 1}))},
            {R"("node":0,"path":"weights")"});
  const Scene scene = load();
  test::expectSound(scene);
  EXPECT_EQ(test::countOf(scene.repairs, "unused vertices"), 2U);
  EXPECT_GT(test::countOf(scene.repairs, "duplicate vertices"), 0U);
  EXPECT_EQ(test::countOf(scene.repairs, "inward orientation"), 4U);
  const Object& object = scene.objects[0];
  const Rig& rig = *object.rig;
  ASSERT_EQ(rig.positions.size(), object.mesh.positionsMm.size());
  for (std::size_t v = 0; v < rig.positions.size(); ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_FLOAT_EQ(1000 * rig.positions[v][axis], object.mesh.positionsMm[v][axis]);
      EXPECT_FLOAT_EQ(10 * rig.positions[v][axis], rig.targets[0].positions[v][axis]);
      EXPECT_NEAR(rig.normals[v][axis], object.mesh.normals[v][axis], 1e-6F);
      // The file's offsets of normals equal its normals, so they must turn with them.
      EXPECT_GE(rig.normals[v][axis] * rig.targets[0].normals[v][axis], 0);
    }
  }
}

TEST_F(GltfAnimation, VerticesThatMoveApartStayTwo) {
  // The first corner twice, each time with another offset.
  std::vector<float> positions = tetrahedronCorners;
  positions.insert(positions.end(), {0, 0, 0});
  position = b.vectors(positions);
  normal = b.vectors({-1, -1, -1, 1, 0, 0, 0, 1, 0, 0, 0, 1, -1, -1, -1});
  index = b.add<std::uint16_t>({0, 2, 1, 0, 1, 3, 4, 3, 2, 1, 2, 3}, "SCALAR", 1);
  const int offset = b.vectors({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0});
  mesh("", fmt::format(R"(,"targets":[{{"POSITION":{}}}])", offset));
  b.animate("swell", {GltfBuilder::sampler(times, b.scalars({0, 1}))},
            {R"("node":0,"path":"weights")"});
  EXPECT_EQ(load().objects[0].rig->positions.size(), 5U);
}

TEST_F(GltfAnimation, WeightsThatNeverChangeAreFoldedIn) {
  b.nodes = R"({"mesh":0,"weights":[0.5]})";
  mesh("", fmt::format(R"(,"targets":[{{"POSITION":{}}}])", position));
  moveNode(0);
  const Scene scene = load();
  const Rig& rig = *scene.objects[0].rig;
  EXPECT_TRUE(rig.targets.empty());
  for (std::size_t v = 0; v < 4; ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_FLOAT_EQ(1000 * rig.positions[v][axis], scene.objects[0].mesh.positionsMm[v][axis]);
    }
  }
  EXPECT_FLOAT_EQ(boundsOf(scene).maxMm[0], 1500);
}

TEST_F(GltfAnimation, FacesLostAtRestAreNoted) {
  index = b.add<std::uint16_t>({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3, 0, 0, 1}, "SCALAR", 1);
  mesh("");
  moveNode(0);
  load();
  EXPECT_THAT(notes, ElementsAre(HasSubstr("1 faces that have no area")));
}

TEST_F(GltfAnimation, ChannelsThatMoveNothingAreLeftOut) {
  b.nodes = R"({"mesh":0},{"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]})";
  const int values = b.vectors({0, 0, 0, 1, 2, 3});
  b.animate("odd", {GltfBuilder::sampler(times, values)},
            {R"("node":1,"path":"translation")", R"("node":0,"path":"weights")",
             R"("node":0,"path":"pointer")"});
  const Scene scene = load();
  EXPECT_TRUE(scene.clips.empty());
  EXPECT_TRUE(scene.nodes.empty());
  EXPECT_FALSE(scene.objects[0].rig);
  EXPECT_THAT(notes, ElementsAre(HasSubstr("3 animation channels")));
}

TEST_F(GltfAnimation, TracksThatLieAreErrors) {
  const GltfBuilder before = b;
  const auto with = [&](const auto& input, const auto& output, const char* path,
                        const char* interpolation = "LINEAR", int node = 0) {
    b = before;
    const int in = b.scalars(input);
    const int out = output(b);
    b.animate("bad", {GltfBuilder::sampler(in, out, interpolation)},
              {fmt::format(R"("node":{},"path":"{}")", node, path)});
    return error();
  };
  using Values = std::vector<float>;
  const auto two = [](GltfBuilder& to) { return to.vectors({0, 0, 0, 1, 1, 1}); };
  EXPECT_THAT(with(Values{0, 0}, two, "translation"), HasSubstr("do not ascend"));
  EXPECT_THAT(with(Values{2, 1}, two, "translation"), HasSubstr("do not ascend"));
  EXPECT_THAT(with(Values{-1, 1}, two, "translation"), HasSubstr("negative or not finite"));
  EXPECT_THAT(with(Values{0, NAN}, two, "translation"), HasSubstr("not finite"));
  EXPECT_THAT(with(Values{NAN, 1}, two, "translation"), HasSubstr("not finite"));
  EXPECT_THAT(with(Values{0, INFINITY}, two, "translation"), HasSubstr("not finite"));
  EXPECT_THAT(with(Values{0, 1, 2}, two, "translation"), HasSubstr("2 elements where 3"));
  EXPECT_THAT(with(Values{0, 1}, two, "translation", "CUBICSPLINE"),
              HasSubstr("2 elements where 6"));
  EXPECT_THAT(with(Values{0, 1}, two, "rotation"), HasSubstr("another type"));
  EXPECT_THAT(with(Values{0, 1}, two, "translation", "BEZIER"), HasSubstr("BEZIER"));
  EXPECT_THAT(with(Values{0, 1}, two, "translation", "LINEAR", 7), HasSubstr("node 7"));
  EXPECT_THAT(with(
                  Values{0, 1},
                  [](GltfBuilder& to) {
                    return to.vectors({0, 0, 0, NAN, 1, 1});
                  },
                  "translation"),
              HasSubstr("not finite"));
  EXPECT_THAT(with(
                  Values{0, 1}, [](GltfBuilder&) { return 99; }, "translation"),
              HasSubstr("accessor 99"));
  b = before;
  b.animate("bad", {}, {R"("node":0,"path":"translation")"});
  EXPECT_THAT(error(), HasSubstr("sampler"));
}

TEST_F(GltfAnimation, RigsThatLieAreErrors) {
  const GltfBuilder before = b;
  const auto swell = [&] {
    b.animate("swell", {GltfBuilder::sampler(times, b.scalars({0, 1}))},
              {R"("node":0,"path":"weights")"});
  };
  const int broken = b.vectors({0, 0, 0, 0, NAN, 0, 0, 0, 0, 0, 0, 0});
  mesh("", fmt::format(R"(,"targets":[{{"POSITION":{}}}])", broken));
  swell();
  EXPECT_THAT(error(), HasSubstr("not finite"));
  // Two primitives, one of them without targets.
  b = before;
  b.meshes = fmt::format(
      R"({{"primitives":[{{"attributes":{{"POSITION":{0}}},"indices":{1},)"
      R"("targets":[{{"POSITION":{0}}}]}},{{"attributes":{{"POSITION":{0}}},"indices":{1}}}]}})",
      position, index);
  swell();
  EXPECT_THAT(error(), HasSubstr("how many morph targets"));
  b = before;
  b.nodes = R"({"mesh":0,"translation":[1e300,0,0]})";
  moveNode(0);
  EXPECT_THAT(error(), HasSubstr("out of range"));
}

/// Few vertices that many flat triangles name over and over, with many targets.
TEST_F(GltfAnimation, BlownUpTargetsAreRefusedBeforeMemoryIs) {
  constexpr std::uint16_t count = 64;
  constexpr int targetCount = 500;
  std::vector<float> points;
  for (int v = 0; v < count; ++v) {
    const auto x = static_cast<float>(v);
    points.insert(points.end(), {x, x * x, x * x * x});  // no three on a line
  }
  std::vector<std::uint16_t> corner;
  for (std::uint16_t i = 0; i < count; ++i) {
    for (std::uint16_t j = i + 1; j < count; ++j) {
      for (std::uint16_t k = j + 1; k < count; ++k) corner.insert(corner.end(), {i, j, k});
    }
  }
  position = b.vectors(points);
  index = b.add(corner, "SCALAR", 1);
  std::string targets;
  for (int i = 0; i < targetCount; ++i) {
    targets += fmt::format(R"({}{{"POSITION":{}}})", i > 0 ? "," : "", position);
  }
  flatMesh(R"(,"targets":[)" + targets + "]");
  b.animate("swell",
            {GltfBuilder::sampler(b.scalars({0}), b.scalars(std::vector<float>(targetCount)))},
            {R"("node":0,"path":"weights")"});
  EXPECT_THAT(error(), HasSubstr("are more than"));
}

}  // namespace
}  // namespace opaline
