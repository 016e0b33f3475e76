#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/formats.h"

namespace opaline::scene {

/// What has to be known of the JSON before a recursive parser that copies what it is told may see
/// it.
struct GltfPrescan {
  std::set<std::string> bufferFiles;  ///< external, percent-decoded
  std::vector<std::string> extensionsUsed{};
  std::vector<std::string> extensionsRequired{};  ///< all read
};

/// Throws Error for bytes that are no JSON, nested too deep, with too many values, or with several
/// buffers in the binary chunk.
GltfPrescan prescanGltf(const Input& input, std::string_view json);

/// A URI's %20 become spaces, and so on.
std::string percentDecoded(std::string_view uri);

}  // namespace opaline::scene
