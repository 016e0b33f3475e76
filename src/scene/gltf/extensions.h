#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/formats.h"

namespace opaline::scene {

/// How this loader treats a glTF extension.
enum class GltfExtension {
  Read,        ///< understood
  Appearance,  ///< concerns textures or materials; shapes are right without it
  Unknown,     ///< may concern where vertices are, or how they are stored
};

GltfExtension kindOf(std::string_view extension);

/// Throws Error, naming them, when a file requires extensions that are not understood: the file
/// says that it looks wrong without them. Extensions that it merely uses may be ignored.
void requireKnownExtensions(const Input& input, const std::vector<std::string>& required);

}  // namespace opaline::scene
