#pragma once

#include <string>
#include <vector>

#include "scene/gltf/accessor.h"
#include "scene/gltf/nodes.h"
#include "scene/gltf/pointers.h"

namespace opaline::scene {

/// Keys of a property that does not belong to a node. Only keys and values of the track count.
struct GltfPointerTrack {
  GltfPointer to;
  Track track;
};

/// What moves in a file. The lists are empty where nothing does.
struct GltfMotion {
  std::vector<Node> nodes;  ///< all of the file, parents first
  std::vector<Clip> clips;
  std::vector<std::vector<GltfPointerTrack>> pointers;  ///< of the clips, in their order
  std::vector<std::string> notAnimated;                 ///< pointers to what cannot be moved here
  std::vector<std::uint32_t> place;  ///< per node of the file its index in `nodes`
  std::vector<bool> moved;           ///< per node of the file: a clip moves it or an ancestor
  std::vector<bool> weighted;        ///< per node of the file: a clip changes its morph weights

  bool any() const { return !clips.empty(); }
};

/// The default weights of a node's morph targets: the node's own, else the mesh's.
const std::vector<double>& defaultWeights(const tinygltf::Model& model, const tinygltf::Node& node);

/// Throws Error for tracks whose parts do not fit each other, times that do not ascend and numbers
/// that are not finite.
GltfMotion readMotion(const Input& input, const tinygltf::Model& model, const GltfNodes& nodes,
                      GltfAccessors& accessors);

}  // namespace opaline::scene
