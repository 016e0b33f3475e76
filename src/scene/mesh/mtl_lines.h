#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace opaline::scene {

/// A .mtl file as tinyobjloader shall read it, and what of it no picture shows.
struct MtlLines {
  /// Only lines with keys that are read, in their usual case. Of the options of textures only
  /// -clamp is left.
  std::string text;
  std::map<std::string, std::set<std::string>> notShown;  ///< by the name of the material
};

MtlLines mtlLines(std::string_view text);

}  // namespace opaline::scene
