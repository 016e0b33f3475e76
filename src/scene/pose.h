#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "opaline/scene.h"
#include "scene/matrix.h"

namespace opaline::scene {

/// A node's transform relative to its parent.
struct LocalTransform {
  Double3 translation{0, 0, 0};
  std::array<double, 4> rotation{0, 0, 0, 1};  ///< x y z w
  Double3 scale{1, 1, 1};
};

/// Where the nodes of a scene are at one time, and the weights of their morph targets.
struct Pose {
  std::vector<Matrix4> world;              ///< per node, from the node to the nodes' common space
  std::vector<float> weights;              ///< of all nodes, end to end
  std::vector<std::uint32_t> firstWeight;  ///< per node and one more
  std::vector<LocalTransform> local;       ///< per node; unused for one that has a matrix
};

/// A pose with room for a scene's nodes, which stand as in the file.
Pose makePose(const Scene& scene);

/// Evaluates a clip. -1 means no clip: the nodes stand as in the file. The pose must come from
/// makePose() for this scene. Allocates nothing.
void poseAt(const Scene& scene, int clip, double seconds, Pose& pose);

/// The time within the clip: unchanged up to the clip's end, beyond it modulo the clip's length.
double clipTime(const Clip& clip, double seconds);

/// toScene · world · inverseBind of every joint of a rig, or toScene · world of its node where it
/// has no joints; `matrices` has one place for each. Allocates nothing.
void jointMatrices(const Rig& rig, const Pose& pose, std::span<Matrix4> matrices);

/// Whether most of a rig's matrices mirror, so that its triangles turn.
bool mirrors(std::span<const Matrix4> matrices);

/// The weights of a rig's morph targets, one for each. A weight that the node lacks is 0.
std::span<const float> morphWeights(const Rig& rig, const Pose& pose);

}  // namespace opaline::scene
