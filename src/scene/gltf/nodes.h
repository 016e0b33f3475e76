#pragma once

#include <vector>

#include "scene/gltf/file.h"
#include "scene/matrix.h"

namespace opaline::scene {

/// The node hierarchy, walked without recursion.
struct GltfNodes {
  std::vector<Matrix4> world;  ///< per node, from the node to the scene
  std::vector<int> parents;    ///< per node, or -1
  std::vector<int> order;      ///< all nodes, parents first
  std::vector<int> drawn;      ///< nodes of the default scene, parents first
};

/// Throws Error for nodes that do not exist, have two parents or form a cycle.
GltfNodes resolveNodes(const Input& input, const tinygltf::Model& model);

}  // namespace opaline::scene
