#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace opaline::bench {

/// Files that are awkward in one way, of any size.
struct Family {
  const char* name;
  const char* extension;
  /// The bytes of one with so many triangles, or nodes.
  std::string (*file)(std::uint32_t count);
};

const std::vector<Family>& families();

}  // namespace opaline::bench
