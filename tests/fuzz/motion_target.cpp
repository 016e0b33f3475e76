#include <gtest/gtest.h>

#include <vector>

#include "deform/deformed_vertices.h"
#include "input.h"
#include "scene/pose.h"

namespace {

using namespace opaline;

constexpr std::uint32_t mostNodes = 12;

Vec3 vectorFrom(fuzz::Input& input) {
  Vec3 v{};
  for (float& x : v) x = static_cast<float>(input.take<std::int8_t>()) / 16;
  return v;
}

Node nodeFrom(fuzz::Input& input, int index) {
  Node node;
  node.parent = static_cast<int>(input.below(static_cast<std::uint32_t>(index) + 1)) - 1;
  node.translation = vectorFrom(input);
  node.scale = vectorFrom(input);
  if (input.below(4) == 0) {
    node.matrix.emplace();
    for (Vec3& column : node.matrix->columns) column = vectorFrom(input);
  }
  node.morphWeights.assign(input.below(3), 0.5F);
  return node;
}

Track trackFrom(fuzz::Input& input, const std::vector<Node>& nodes) {
  Track track;
  track.node = input.below(static_cast<std::uint32_t>(nodes.size()));
  track.target = static_cast<TrackTarget>(input.below(4));
  track.interpolation = static_cast<Interpolation>(input.below(3));
  const std::size_t weights = nodes[track.node].morphWeights.size();
  if (track.target == TrackTarget::MorphWeights && weights == 0)
    track.target = TrackTarget::Translation;
  const std::size_t width = track.target == TrackTarget::Rotation       ? 4
                            : track.target == TrackTarget::MorphWeights ? weights
                                                                        : 3;
  float seconds = 0;
  for (std::uint32_t keys = 1 + input.below(5); keys > 0; --keys) {
    track.seconds.push_back(seconds);
    seconds += 0.01F + static_cast<float>(input.below(256)) / 16;
  }
  const std::size_t parts = track.interpolation == Interpolation::CubicSpline ? 3 : 1;
  for (std::size_t i = 0; i < parts * width * track.seconds.size(); ++i)
    track.values.push_back(static_cast<float>(input.take<std::int8_t>()) / 32);
  return track;
}

Rig rigFrom(fuzz::Input& input, const Mesh& mesh, const std::vector<Node>& nodes) {
  Rig rig;
  const auto anyNode = [&] { return input.below(static_cast<std::uint32_t>(nodes.size())); };
  rig.node = anyNode();
  rig.positions = mesh.positionsMm;
  rig.normals = mesh.normals;
  for (std::uint32_t count = input.below(3); count > 0; --count) {
    MorphTarget& target = rig.targets.emplace_back();
    for (std::size_t v = 0; v < mesh.positionsMm.size(); ++v)
      target.positions.push_back(vectorFrom(input));
    if (input.below(2) == 0) target.normals = target.positions;
  }
  const std::uint32_t joints = input.below(4);
  for (std::uint32_t joint = 0; joint < joints; ++joint) {
    rig.joints.push_back({anyNode(), {}});
    for (Vec3& column : rig.joints.back().inverseBind.columns) column = vectorFrom(input);
  }
  if (joints == 0) return rig;
  rig.firstInfluence.push_back(0);
  for (std::size_t v = 0; v < mesh.positionsMm.size(); ++v) {
    rig.influences.push_back({input.below(joints), 1});
    rig.firstInfluence.push_back(static_cast<std::uint32_t>(rig.influences.size()));
  }
  return rig;
}

Scene sceneFrom(fuzz::Input& input) {
  Scene scene;
  for (std::uint32_t count = 1 + input.below(mostNodes); count > 0; --count)
    scene.nodes.push_back(nodeFrom(input, static_cast<int>(scene.nodes.size())));
  Clip& clip = scene.clips.emplace_back();
  for (std::uint32_t count = input.below(6); count > 0; --count) {
    clip.tracks.push_back(trackFrom(input, scene.nodes));
    clip.seconds = std::max(clip.seconds, clip.tracks.back().seconds.back());
  }
  Object& object = scene.objects.emplace_back();
  object.mesh.positionsMm = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  object.mesh.normals.assign(4, {0, 0, 1});
  object.mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  object.mesh.facetted = input.below(2) == 0;
  object.rig = rigFrom(input, object.mesh, scene.nodes);
  for (std::uint32_t count = input.below(3); count > 0; --count) {
    Deformer& deformer = scene.deformers.emplace_back();
    deformer.kind = static_cast<DeformerKind>(input.below(4));
    deformer.amount = static_cast<float>(input.take<std::int8_t>()) / 143;  // all kinds allow 0.9
    deformer.periodSeconds = static_cast<float>(input.below(16));
  }
  return scene;
}

}  // namespace

// Nodes, a clip, a rig and deformers of a tetrahedron.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  const Scene scene = sceneFrom(input);
  for (const int clip : {-1, 0})
    for (const double seconds : {0.0, 0.37, 5.0, 1e6}) {
      const deform::DeformedVertices moved = deform::deformedVertices(scene, 0, clip, seconds);
      for (const scene::Double3& p : moved.positionsMm)
        EXPECT_TRUE(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]));
      for (const scene::Double3& n : moved.normals)
        EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-6);
    }
  return 0;
}
