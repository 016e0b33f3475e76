#pragma once

#include "scene/gltf_accessor.h"
#include "scene/gltf_nodes.h"

namespace opaline::scene {

/// One primitive of a node, morphed by its default weights, skinned by the hierarchy's rest
/// transform and placed in the scene; empty for points and lines.
RawMesh bakePrimitive(const Input& input, const tinygltf::Model& model, const GltfNodes& nodes,
                      GltfAccessors& accessors, std::size_t node,
                      const tinygltf::Primitive& primitive);

/// Whether the mode of a primitive makes triangles.
bool isSurface(const tinygltf::Primitive& primitive);

}  // namespace opaline::scene
