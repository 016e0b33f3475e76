#pragma once

#include <cstddef>

namespace opaline::core {

/// While it lives, stb_image on this thread gets no block of memory larger than that: a few bytes
/// of compressed zeros would otherwise make it allocate gigabytes.
class StbMemoryLimit {
 public:
  explicit StbMemoryLimit(std::size_t largestBlockBytes);
  ~StbMemoryLimit();
  StbMemoryLimit(const StbMemoryLimit&) = delete;
  StbMemoryLimit& operator=(const StbMemoryLimit&) = delete;
};

}  // namespace opaline::core
