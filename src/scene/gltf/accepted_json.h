#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/gltf/prescan.h"

namespace opaline::scene {

/// Whether some of a file's buffers may hold no bytes, being named by compressed views only.
bool mayHavePlaceholders(const GltfPrescan& prescan);

/// The JSON of a file that has been scanned, changed where tinygltf refuses what extensions allow:
/// each placeholder gets one byte, each primitive that Draco compresses loses its indices, which
/// are empty, and each channel with a pointer gets a node, its own if the pointer leads to one.
/// None if there is nothing to change.
std::optional<std::string> acceptedJson(const GltfPrescan& prescan, std::string_view json);

}  // namespace opaline::scene
