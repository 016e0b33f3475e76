#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/formats.h"

namespace opaline::scene {

/// What must be known of the JSON before it reaches a recursive parser, which copies whatever it is
/// told to.
struct GltfPrescan {
  std::set<std::string> bufferFiles;  ///< external, percent-decoded
  std::vector<std::string> extensionsUsed{};
  std::vector<std::string> extensionsRequired{};  ///< all of them understood
};

/// Throws Error for bytes that are not JSON, for JSON that is nested too deep or has too many
/// values, and for buffers whose data are nowhere or all in the binary chunk.
GltfPrescan prescanGltf(const Input& input, std::string_view json, bool binary);

/// Decodes the %20 and the like of a URI.
std::string percentDecoded(std::string_view uri);

}  // namespace opaline::scene
