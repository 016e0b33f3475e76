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
  std::optional<OpaqueMaterial> opaque;  ///< if set, the other does not count
};

/// The materials of one file. One with no sign of translucency is opaque; a primitive without any
/// is of the default medium.
class GltfMaterials {
 public:
  GltfMaterials(const Input& input, const tinygltf::Model& model)
      : input_(input), model_(model), textures_(input, model) {}

  /// Names of meshes and nodes may be those of media. Throws Error for a material that does not
  /// exist.
  GltfSurface surface(int material, std::string_view meshName, std::string_view nodeName);

  /// An opaque one, as this says, whatever else there is of it.
  OpaqueMaterial opaqueOf(const tinygltf::Material& of) { return read(of); }

  /// Those that have been asked for and are opaque.
  std::set<int> opaque() const;

 private:
  OpaqueMaterial read(const tinygltf::Material& of);
  std::optional<TranslucentSurface> readSurface(const tinygltf::Material& of);

  const Input& input_;
  const tinygltf::Model& model_;
  GltfTextures textures_;
  std::map<int, OpaqueMaterial> opaque_;
};

}  // namespace opaline::scene
