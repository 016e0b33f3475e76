#pragma once

#include <optional>

#include "scene/gltf/accessor.h"
#include "scene/gltf/animation.h"
#include "scene/gltf/nodes.h"

namespace opaline::scene {

struct BakedPrimitive {
  RawMesh mesh;                 ///< in the rest pose; its provenance names the primitive's vertices
  VertexAttributes attributes;  ///< of the primitive's vertices
  std::optional<Rig> rig;       ///< where a clip can move it
};

/// One primitive of a node, morphed by its default weights, skinned by the hierarchy's rest
/// transform and placed in the scene.
BakedPrimitive bakePrimitive(const Input& input, const tinygltf::Model& model,
                             const GltfNodes& nodes, const GltfMotion& motion,
                             GltfAccessors& accessors, std::size_t node,
                             const tinygltf::Primitive& primitive);

/// Whether the mode of a primitive produces triangles.
bool isSurface(const tinygltf::Primitive& primitive);

}  // namespace opaline::scene
