#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace opaline::bench {

/// A kind of file that is awkward in one way, in any size.
struct Family {
  const char* name;
  const char* extension;
  /// The bytes of such a file with so many triangles or nodes.
  std::string (*file)(std::uint32_t count);
};

const std::vector<Family>& families();

}  // namespace opaline::bench
