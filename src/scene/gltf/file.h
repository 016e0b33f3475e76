#pragma once

#include <string>

// No part of the library that decodes images or opens files: readGltf() does what is needed of
// that.
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_FS
// The library's header does not pass this project's warnings.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#include <tiny_gltf.h>
#pragma GCC diagnostic pop

#include "scene/formats.h"

namespace opaline::scene {

/// Throws Error: "FILE: REASON".
[[noreturn]] void failGltf(const Input& input, const std::string& reason);

/// Reads the JSON and the buffers, from the file itself and from its own folder only. Data that
/// are compressed are decoded. Images are as they are stored; those in files of their own are not
/// read.
tinygltf::Model readGltf(const Input& input);

}  // namespace opaline::scene
