// The positions that the device computes, against the host's in double precision, and given
// positions.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "deform/deformed_vertices.h"
#include "gpu/command_list.h"
#include "gpu/gpu_fixture.h"
#include "gpu/transfer.h"
#include "opaline/renderer.h"
#include "passes/deform/deform_pass.h"
#include "renderer/motion/scene_motion.h"
#include "renderer/scene/scene_resources.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;

struct Moved {
  std::vector<glm::vec4> positions;
  std::vector<glm::vec4> normals;
};

/// A scene on the device, moved by the passes of a frame.
class MotionTest : public gpu::GpuTest {
 protected:
  void put(const Scene& scene) {
    scene_ = scene;
    merged_ = scene::mergedMesh(scene_);
    resources_ = makeSceneResources(device(), scene_, merged_, {});
    motion_ = std::make_unique<SceneMotion>(device(), scene_, merged_, Vec3{});
  }

  void TearDown() override {
    motion_.reset();
    resources_ = {};
    GpuTest::TearDown();
  }

  Moved at(int clip, double seconds) {
    const passes::DeformPass pass(device());
    gpu::CommandList commands(device(), "motion");
    commands.begin();
    motion_->record(commands, pass, {seconds, clip}, resources_.mesh);
    commands.submit();
    commands.wait();
    return {read(resources_.mesh.positions), read(resources_.mesh.normals)};
  }

  void expectAsOnHost(int clip, double seconds) {
    const Moved moved = at(clip, seconds);
    std::size_t first = 0;
    for (std::size_t object = 0; object < scene_.objects.size(); ++object) {
      const deform::DeformedVertices expected =
          deform::deformedVertices(scene_, object, clip, seconds);
      for (std::size_t v = 0; v < expected.positionsMm.size() && !HasFailure(); ++v) {
        expectNear(moved.positions[first + v], expected.positionsMm[v], 1e-5 * diagonalMm(scene_));
        expectNear(moved.normals[first + v], expected.normals[v], 2e-4);
        EXPECT_FALSE(HasFailure()) << "vertex " << v << " at " << seconds << " s";
      }
      first += expected.positionsMm.size();
    }
  }

  static void expectNear(const glm::vec4& found, const scene::Double3& expected, double within) {
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(static_cast<double>(found[axis]), expected[static_cast<std::size_t>(axis)],
                  within);
  }

  static std::vector<glm::vec4> read(gpu::Buffer& buffer) {
    const std::vector<std::byte> bytes = gpu::readBuffer(device(), buffer);
    std::vector<glm::vec4> values(bytes.size() / sizeof(glm::vec4));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }

  Scene scene_;
  scene::MergedMesh merged_;
  SceneResources resources_;
  std::unique_ptr<SceneMotion> motion_;
};

Scene ball() {
  return sceneOf(sphere({1, 2, 3}, 5, 3), marble(), {0, 0, 40}, 6);
}

/// Two joints, one turning about the other, and two morph targets, one with normals.
Scene rigged(Interpolation interpolation, bool normalsOfTargets) {
  Scene scene = ball();
  Object& object = scene.objects[0];
  Node root;
  root.translation = {0.0005F, -0.00025F, 0};
  root.scale = {1, 1.25F, 0.75F};
  root.morphWeights = {0.25F, 0};
  Node tip;
  tip.parent = 0;
  tip.translation = {0, 0.002F, 0};
  scene.nodes = {root, tip};

  Rig rig;
  rig.positions = object.mesh.positionsMm;
  rig.normals = object.mesh.normals;
  for (Vec3& p : rig.positions) p = {0.001F * p[0], 0.001F * p[1], 0.001F * p[2]};
  rig.toScene.columns = {{{1000, 0, 0}, {0, 1000, 0}, {0, 0, 1000}, {3, -1, 2}}};
  rig.joints.resize(2);
  rig.joints[1].node = 1;
  rig.joints[1].inverseBind.columns[3] = {0, -0.002F, 0};
  rig.firstInfluence.push_back(0);
  rig.targets.resize(2);
  for (const Vec3& p : rig.positions) {
    const float weight = std::min(std::max(120 * p[1], 0.0F), 1.0F);
    rig.influences.push_back({0, 1 - weight});
    if (weight > 0) rig.influences.push_back({1, weight});
    rig.firstInfluence.push_back(static_cast<std::uint32_t>(rig.influences.size()));
    rig.targets[0].positions.push_back({p[1], 0, 0});
    rig.targets[1].positions.push_back(p[0] > 0 ? Vec3{0, 0, 0.5F * p[0]} : Vec3{});
    if (normalsOfTargets) {
      rig.targets[0].normals.push_back({0, -0.5F, 0});
      rig.targets[1].normals.push_back({-0.25F, 0, 0});
    }
  }
  object.rig = rig;

  Clip clip;
  clip.name = "all";
  clip.seconds = 2;
  const float half = std::sqrt(0.5F);
  Track turn{1, TrackTarget::Rotation, interpolation, {0, 1, 2}, {}};
  Track weights{0, TrackTarget::MorphWeights, interpolation, {0.5F, 1.5F}, {}};
  const bool cubic = interpolation == Interpolation::CubicSpline;
  // The second quaternion's sign suggests the longer way round.
  const std::vector<std::vector<float>> rotations{
      {0, 0, 0, 1}, {-0.5F, -0.5F, -0.5F, -0.5F}, {half, 0, 0, half}};
  for (const std::vector<float>& q : rotations) {
    if (cubic) turn.values.insert(turn.values.end(), {0, 0.25F, 0, 0});
    turn.values.insert(turn.values.end(), q.begin(), q.end());
    if (cubic) turn.values.insert(turn.values.end(), {0, 0, -0.5F, 0});
  }
  for (const float w : {0.75F, -0.5F}) {
    if (cubic) weights.values.insert(weights.values.end(), {1, -1});
    weights.values.insert(weights.values.end(), {w, 1 - w});
    if (cubic) weights.values.insert(weights.values.end(), {0, 2});
  }
  clip.tracks = {turn, weights};
  scene.clips = {clip};
  return scene;
}

TEST_F(MotionTest, SkinAndMorphAsOnTheHost) {
  for (const Interpolation interpolation :
       {Interpolation::Step, Interpolation::Linear, Interpolation::CubicSpline}) {
    SCOPED_TRACE(static_cast<int>(interpolation));
    put(rigged(interpolation, true));
    for (const double seconds : {0.0, 0.3, 0.5, 1.0, 1.21, 2.0, 2.7}) expectAsOnHost(0, seconds);
    expectAsOnHost(-1, 0.8);
  }
}

TEST_F(MotionTest, NormalsFromTheMeshWhereTargetsHaveNone) {
  put(rigged(Interpolation::Linear, false));
  for (const double seconds : {0.0, 0.9, 1.8}) expectAsOnHost(0, seconds);
}

TEST_F(MotionTest, FacettedMeshesStayFacetted) {
  Scene scene = rigged(Interpolation::Linear, true);
  Object& object = scene.objects[0];
  Rig& rig = *object.rig;
  Mesh facets;
  Rig own;
  own.toScene = rig.toScene;
  own.node = 1;
  for (const Triangle& t : object.mesh.triangles) {
    const auto base = static_cast<std::uint32_t>(facets.positionsMm.size());
    for (const std::uint32_t v : t) {
      facets.positionsMm.push_back(object.mesh.positionsMm[v]);
      facets.normals.push_back(object.mesh.normals[v]);
      own.positions.push_back(rig.positions[v]);
      own.normals.push_back(rig.normals[v]);
    }
    facets.triangles.push_back({base, base + 1, base + 2});
  }
  facets.facetted = true;
  object.mesh = facets;
  object.rig = own;
  scene.deformers = {{DeformerKind::Bend, 1.5F, 0}};
  put(scene);
  expectAsOnHost(0, 0.7);
}

// A clip mirrors a body that is not mirrored at rest: the same sphere, still right side out.
TEST_F(MotionTest, MirroredByAClipStaysRightSideOut) {
  for (const bool facetted : {false, true}) {
    Scene scene = ball();
    Object& object = scene.objects[0];
    object.mesh.facetted = facetted;
    scene.nodes.resize(1);
    Rig rig;
    rig.positions = object.mesh.positionsMm;
    rig.normals = object.mesh.normals;
    for (Vec3& p : rig.positions) p = {p[0] - 1, p[1] - 2, p[2] - 3};
    rig.toScene.columns[3] = {1, 2, 3};
    object.rig = rig;
    scene.clips = {{"mirror",
                    1,
                    {{0, TrackTarget::Scale, Interpolation::Linear, {0, 1}, {1, 1, 1, -1, 1, 1}}}}};
    put(scene);
    const Moved moved = at(0, 1);
    for (std::size_t v = 0; v < moved.normals.size(); ++v) {
      const glm::vec3 outward = (glm::vec3(moved.positions[v]) - glm::vec3(1, 2, 3)) / 5.0F;
      ASSERT_GT(glm::dot(outward, glm::vec3(moved.normals[v])), 0.9F);
      ASSERT_EQ(moved.normals[v].w, -1);
    }
    if (!facetted) expectAsOnHost(0, 1);
  }
}

TEST_F(MotionTest, DeformersAsOnTheHost) {
  Scene scene = ball();
  const std::vector<Deformer> all{
      {DeformerKind::Twist, 2.5F, 0},   {DeformerKind::Bend, -1.2F, 3},
      {DeformerKind::Bend, 1e-4F, 0},   {DeformerKind::Squash, 0.6F, 2},
      {DeformerKind::Squash, -1.5F, 0}, {DeformerKind::Wobble, 0.1F, 0.7F}};
  for (const Deformer& deformer : all) {
    SCOPED_TRACE(static_cast<int>(deformer.kind));
    scene.deformers = {deformer};
    put(scene);
    for (const double seconds : {0.0, 0.4, 1.3, 1000.1}) expectAsOnHost(0, seconds);
  }
  scene.deformers = all;
  put(scene);
  expectAsOnHost(0, 0.6);
}

TEST_F(MotionTest, DeformersFollowRigs) {
  Scene scene = rigged(Interpolation::Linear, true);
  scene.deformers = {{DeformerKind::Twist, 1, 0}, {DeformerKind::Squash, 0.3F, 0}};
  put(scene);
  expectAsOnHost(0, 1.4);
}

std::vector<Vec3> shifted(std::vector<Vec3> positions, float by) {
  for (Vec3& p : positions) p[0] += by;
  return positions;
}

TEST_F(MotionTest, GivenPositionsHoldUntilRestored) {
  put(rigged(Interpolation::Linear, true));
  const std::vector<Vec3>& rest = scene_.objects[0].mesh.positionsMm;
  const std::vector<Vec3> given = shifted(rest, 7);
  motion_->given().give(0, given, motion_->tables());
  for (int frame = 0; frame < 4; ++frame) {
    const Moved moved = at(0, 0.3 * frame);
    for (std::size_t v = 0; v < rest.size(); ++v) {
      ASSERT_NEAR(moved.positions[v].x, rest[v][0] + 7, 1e-5);
      // The normal of the sphere through the positions; the mean over triangles is this precise.
      ASSERT_NEAR(moved.normals[v].y, (rest[v][1] - 2) / 5, 0.01);
    }
    motion_->given().give(0, given, motion_->tables());
  }
  motion_->given().restore(0);
  expectAsOnHost(0, 0.9);
}

TEST_F(MotionTest, GivenPositionsFromABufferOfTheDevice) {
  put(ball());
  const std::vector<Vec3>& rest = scene_.objects[0].mesh.positionsMm;
  constexpr std::size_t stride = 5;
  std::vector<float> floats(7 + stride * rest.size(), 99);
  for (std::size_t v = 0; v < rest.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis) floats[7 + stride * v + axis] = 2 * rest[v][axis];
  floats[7 + stride * 11] = std::numeric_limits<float>::quiet_NaN();
  gpu::Buffer buffer =
      gpu::makeBuffer(device(), "caller's", floats, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  motion_->given().give(
      0, DevicePositions{.buffer = buffer.handle(), .offsetBytes = 28, .strideBytes = 20},
      motion_->tables());
  const Moved moved = at(0, 0);
  for (std::size_t v = 0; v < rest.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis)
      ASSERT_NEAR(moved.positions[v][static_cast<int>(axis)], (v == 11 ? 1 : 2) * rest[v][axis],
                  1e-5);
  motion_->given().restore(0);
  expectAsOnHost(0, 0);
}

TEST_F(MotionTest, GivenPositionsThatDoNotFitAreRefused) {
  put(ball());
  GivenPositions& given = motion_->given();
  std::vector<Vec3> positions = scene_.objects[0].mesh.positionsMm;
  EXPECT_THROW(given.give(1, std::span<const Vec3>(positions), motion_->tables()), UsageError);
  positions[3][1] = std::numeric_limits<float>::infinity();
  EXPECT_THROW(given.give(0, std::span<const Vec3>(positions), motion_->tables()), UsageError);
  positions.pop_back();
  EXPECT_THROW(given.give(0, std::span<const Vec3>(positions), motion_->tables()), UsageError);
  EXPECT_THROW(given.give(0, DevicePositions{}, motion_->tables()), UsageError);
  EXPECT_THROW(given.restore(1), UsageError);
}

}  // namespace
}  // namespace opaline
