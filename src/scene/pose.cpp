#include "scene/pose.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/track_sample.h"

namespace opaline::scene {

namespace {

void apply(const Track& track, double seconds, Pose& pose) {
  const TrackSample sample(track, seconds);
  LocalTransform& local = pose.local[track.node];
  switch (track.target) {
    case TrackTarget::Translation:
      if (sample.width() == 3) local.translation = sample.vector();
      return;
    case TrackTarget::Rotation:
      if (sample.width() == 4) local.rotation = sample.rotation();
      return;
    case TrackTarget::Scale:
      if (sample.width() == 3) local.scale = sample.vector();
      return;
    case TrackTarget::MorphWeights: {
      const std::uint32_t first = pose.firstWeight[track.node];
      const std::size_t room = pose.firstWeight[track.node + 1] - first;
      for (std::size_t w = 0; w < std::min(room, sample.width()); ++w) {
        pose.weights[first + w] = static_cast<float>(sample.interpolated(w));
      }
      return;
    }
  }
}

/// Puts every node where the file has it.
void rest(const Scene& scene, Pose& pose) {
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    const auto& q = node.rotation;
    pose.local[n] = {toDouble(node.translation),
                     {double{q[0]}, double{q[1]}, double{q[2]}, double{q[3]}},
                     toDouble(node.scale)};
    const std::uint32_t first = pose.firstWeight[n];
    const std::size_t room = pose.firstWeight[n + 1] - first;
    for (std::size_t w = 0; w < room; ++w) {
      pose.weights[first + w] = w < node.morphWeights.size() ? node.morphWeights[w] : 0.0F;
    }
  }
}

std::vector<std::size_t> weightsPerNode(const Scene& scene) {
  std::vector<std::size_t> counts;
  for (const Node& node : scene.nodes) counts.push_back(node.morphWeights.size());
  for (const Object& object : scene.objects) {
    if (!object.rig) continue;
    std::size_t& count = counts[object.rig->node];
    count = std::max(count, object.rig->targets.size());
  }
  return counts;
}

}  // namespace

Pose makePose(const Scene& scene) {
  Pose pose;
  pose.world.resize(scene.nodes.size());
  pose.local.resize(scene.nodes.size());
  pose.firstWeight.push_back(0);
  for (const std::size_t count : weightsPerNode(scene)) {
    pose.firstWeight.push_back(pose.firstWeight.back() + static_cast<std::uint32_t>(count));
  }
  pose.weights.resize(pose.firstWeight.back());
  poseAt(scene, -1, 0, pose);
  return pose;
}

double clipTime(const Clip& clip, double seconds) {
  if (!std::isfinite(seconds)) return 0;
  const double end{clip.seconds};
  return seconds <= end || !(end > 0) ? seconds : std::fmod(seconds, end);
}

void poseAt(const Scene& scene, int clip, double seconds, Pose& pose) {
  rest(scene, pose);
  if (clip >= 0 && static_cast<std::size_t>(clip) < scene.clips.size()) {
    const Clip& of = scene.clips[static_cast<std::size_t>(clip)];
    const double time = clipTime(of, seconds);
    for (const Track& track : of.tracks) apply(track, time, pose);
  }
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    const LocalTransform& local = pose.local[n];
    const Matrix4 own = node.matrix
                            ? matrixFrom(*node.matrix)
                            : matrixFromParts(local.translation, local.rotation, local.scale);
    pose.world[n] = node.parent < 0 ? own : pose.world[static_cast<std::size_t>(node.parent)] * own;
  }
}

void jointMatrices(const Rig& rig, const Pose& pose, std::span<Matrix4> matrices) {
  const Matrix4 toScene = matrixFrom(rig.toScene);
  if (rig.joints.empty()) {
    matrices[0] = toScene * pose.world[rig.node];
    return;
  }
  for (std::size_t j = 0; j < rig.joints.size(); ++j) {
    const Joint& joint = rig.joints[j];
    matrices[j] = toScene * (pose.world[joint.node] * matrixFrom(joint.inverseBind));
  }
}

bool mirrors(std::span<const Matrix4> matrices) {
  const auto mirroring = std::count_if(matrices.begin(), matrices.end(), [](const Matrix4& matrix) {
    return matrix.determinant() < 0;
  });
  return 2 * static_cast<std::size_t>(mirroring) > matrices.size();
}

std::span<const float> morphWeights(const Rig& rig, const Pose& pose) {
  return std::span(pose.weights).subspan(pose.firstWeight[rig.node], rig.targets.size());
}

}  // namespace opaline::scene
