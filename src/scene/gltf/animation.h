#pragma once

#include <string>
#include <vector>

#include "scene/gltf/accessor.h"
#include "scene/gltf/nodes.h"
#include "scene/gltf/pointers.h"

namespace opaline::scene {

/// Keys of a property that is no node's. Of the track only keys and values count.
struct GltfPointerTrack {
  GltfPointer to;
  Track track;
};

/// What moves in a file. The lists are empty where nothing does.
struct GltfMotion {
  std::vector<Node> nodes;  ///< all of the file, parents first
  std::vector<Clip> clips;
  std::vector<std::vector<GltfPointerTrack>> pointers;  ///< of the clips, in their order
  std::vector<std::string> notAnimated;                 ///< pointers that lead to nothing we move
  std::vector<std::uint32_t> place;  ///< per node of the file its index among `nodes`
  std::vector<bool> moved;           ///< per node of the file: a clip moves it or a node above it
  std::vector<bool> weighted;        ///< per node of the file: a clip weighs its morph targets

  bool any() const { return !clips.empty(); }
};

/// The weights that the file gives the targets of a node's mesh, the node's before the mesh's.
const std::vector<double>& defaultWeights(const tinygltf::Model& model, const tinygltf::Node& node);

/// Throws Error for tracks whose parts do not fit each other, times that do not ascend and numbers
/// that are not finite.
GltfMotion readMotion(const Input& input, const tinygltf::Model& model, const GltfNodes& nodes,
                      GltfAccessors& accessors);

}  // namespace opaline::scene
