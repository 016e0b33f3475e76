#pragma once

#include <optional>
#include <vector>

#include "scene/gltf/animation.h"
#include "scene/gltf/material.h"

namespace opaline::scene {

/// A light of a file at a node, and its index among the scene's lights of its kind.
struct GltfLight {
  std::size_t node = 0;
  std::size_t light = 0;  ///< among the file's
  std::size_t index = 0;
};

/// Which parts of a file became which parts of a scene.
struct GltfParts {
  std::vector<GltfLight> lights;
  std::optional<std::size_t> cameraNode;  ///< of the scene's camera
  std::vector<int> materialOfObject;      ///< among the file's, -1: none
};

/// Whether a clip changes that material.
bool isAnimated(const GltfMotion& motion, int material);

/// What the clips of a file change in the scene's lights, its camera and its objects' materials.
/// `scene` must be complete. Values are sampled at the keys, and in between so densely that the
/// sampling is not seen. What cannot be changed is added to what is not shown.
std::vector<ClipChanges> readChanges(const Input& input, const tinygltf::Model& model,
                                     const GltfNodes& nodes, const GltfMotion& motion,
                                     const GltfParts& parts, GltfMaterials& materials,
                                     RawScene& scene);

}  // namespace opaline::scene
