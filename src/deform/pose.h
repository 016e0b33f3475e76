#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "opaline/scene.h"
#include "scene/matrix.h"

namespace opaline::deform {

/// Where the nodes of a scene are at one time, and the weights of their morph targets.
struct Pose {
  std::vector<scene::Matrix4> world;       ///< per node, from the node to the nodes' common space
  std::vector<float> weights;              ///< all nodes' end to end
  std::vector<std::uint32_t> firstWeight;  ///< per node and one more
};

/// A pose with room for a scene's nodes, as the file has them.
Pose makePose(const Scene& scene);

/// Evaluates a clip; -1 is none, the nodes as the file has them. Allocates nothing.
void poseAt(const Scene& scene, int clip, double seconds, Pose& pose);

/// toScene · world · inverseBind of every joint of a rig, or toScene · world of its node where it
/// has no joints; `matrices` has one place for each. Allocates nothing.
void jointMatrices(const Rig& rig, const Pose& pose, std::span<scene::Matrix4> matrices);

/// The weights of a rig's morph targets; those that the node does not give are 0.
std::span<const float> morphWeights(const Rig& rig, const Pose& pose);

}  // namespace opaline::deform
