#pragma once

#include <string>

// The library's header does not pass this project's warnings.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#include <tiny_gltf.h>
#pragma GCC diagnostic pop

#include "scene/formats.h"

namespace opaline::scene {

/// Throws Error: "FILE: REASON".
[[noreturn]] void failGltf(const Input& input, const std::string& reason);

/// Reads the JSON and the buffers, from the file itself and from its own folder only. Images are
/// not decoded.
tinygltf::Model readGltf(const Input& input);

}  // namespace opaline::scene
