#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/formats.h"

namespace opaline::scene {

/// What becomes of an extension of glTF here.
enum class GltfExtension {
  Read,        ///< understood
  Appearance,  ///< of textures and materials; without it shapes are right all the same
  Unknown,     ///< may say where the vertices are, or how they are stored
};

GltfExtension kindOf(std::string_view extension);

/// Throws Error, naming them, when a file requires extensions that are not understood: it says that
/// it looks wrong without them. What it only uses may be left out.
void requireKnownExtensions(const Input& input, const std::vector<std::string>& required);

}  // namespace opaline::scene
