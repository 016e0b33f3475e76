#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/gltf/prescan.h"

namespace opaline::scene {

/// Whether some of a file's buffers may hold no bytes because only compressed views name them.
bool mayHavePlaceholders(const GltfPrescan& prescan);

/// The JSON of a file that has been scanned, changed where tinygltf refuses what extensions allow.
/// Each placeholder gets one byte. Each primitive that Draco compresses loses its indices, which
/// are empty. Each channel with a pointer gets a node: the one it points to, if any. None if there
/// is nothing to change.
std::optional<std::string> acceptedJson(const GltfPrescan& prescan, std::string_view json);

}  // namespace opaline::scene
