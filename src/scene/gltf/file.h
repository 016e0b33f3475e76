#pragma once

#include <string>

// The library must neither decode images nor open files; readGltf() does what is needed.
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_FS
// The library's header triggers warnings that this project enables.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#include <tiny_gltf.h>
#pragma GCC diagnostic pop

#include "scene/formats.h"

namespace opaline::scene {

/// Throws Error: "FILE: REASON".
[[noreturn]] void failGltf(const Input& input, const std::string& reason);

/// Reads the JSON and the buffers, only from the file itself and from its folder. Compressed data
/// are decoded. Images stay encoded; those in files of their own are not read.
tinygltf::Model readGltf(const Input& input);

}  // namespace opaline::scene
