#pragma once

#include <cstdint>
#include <vector>

#include "scene/gltf/draft.h"
#include "scene/gltf/nodes.h"

namespace opaline::scene {

/// A joint of a skin, by the node's number in the file.
struct GltfJoint {
  std::size_t node = 0;
  Matrix4 inverseBind;
};

/// How the joints of a skin move the vertices of one primitive.
struct GltfSkin {
  std::vector<GltfJoint> joints;
  std::vector<std::uint32_t> firstInfluence;  ///< per vertex and one more
  std::vector<Influence> influences;          ///< weights of a vertex sum to 1

  bool empty() const { return joints.empty() || influences.empty(); }
};

/// Reads any number of sets of four influences. Weights are scaled to a sum of 1; vertices without
/// any follow the first joint. Empty where the primitive or the skin has none.
GltfSkin readSkin(const Input& input, const tinygltf::Model& model, GltfAccessors& accessors,
                  int skin, const tinygltf::Primitive& primitive, std::size_t vertices);

/// Skins by the transforms that the file gives its nodes (glTF 2.0, section 3.7.3).
void skinBy(const GltfSkin& skin, const GltfNodes& nodes, Draft& draft);

}  // namespace opaline::scene
