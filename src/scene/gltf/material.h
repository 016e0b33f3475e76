#pragma once

#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "scene/gltf/textures.h"
#include "scene/material.h"

namespace opaline::scene {

/// What a primitive is made of.
struct GltfSurface {
  Translucent translucent;
  std::optional<OpaqueMaterial> opaque;  ///< if set, `translucent` does not count
};

/// The materials of one file. A material without a sign of translucency is opaque. A primitive
/// without a material gets the default medium.
class GltfMaterials {
 public:
  GltfMaterials(const Input& input, const tinygltf::Model& model)
      : input_(input), model_(model), textures_(input, model) {}

  /// Meshes and nodes may be named after media. Throws Error for a material that does not exist.
  GltfSurface surface(int material, std::string_view meshName, std::string_view nodeName);

  /// What a material says when it is read as an opaque one.
  OpaqueMaterial opaqueOf(const tinygltf::Material& of) { return read(of); }

  /// The materials that have been asked for and are opaque.
  std::set<int> opaque() const;

  /// Of all that have been asked for.
  const std::vector<NotShown>& unreadableTextures() const { return textures_.unreadable(); }

 private:
  OpaqueMaterial read(const tinygltf::Material& of);
  std::optional<TranslucentSurface> readSurface(const tinygltf::Material& of);

  const Input& input_;
  const tinygltf::Model& model_;
  GltfTextures textures_;
  std::map<int, OpaqueMaterial> opaque_;
};

}  // namespace opaline::scene
