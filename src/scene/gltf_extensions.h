#pragma once

#include <string_view>

#include "scene/gltf_file.h"

namespace opaline::scene {

/// What becomes of an extension of glTF here.
enum class GltfExtension {
  Read,        ///< understood
  Appearance,  ///< of textures and materials; without it shapes are right all the same
  Unknown,     ///< may say where the vertices are, or how they are stored
};

GltfExtension kindOf(std::string_view extension);

/// Throws Error, naming them, when the file requires extensions that are unknown here.
void requireKnownExtensions(const Input& input, const tinygltf::Model& model);

}  // namespace opaline::scene
