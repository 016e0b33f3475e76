#pragma once

#include <cstddef>

namespace opaline::core {

/// While it lives, stb_image gets no larger block of memory on this thread. Otherwise a few bytes
/// of compressed zeros could make it allocate gigabytes.
class StbMemoryLimit {
 public:
  explicit StbMemoryLimit(std::size_t largestBlockBytes);
  ~StbMemoryLimit();
  StbMemoryLimit(const StbMemoryLimit&) = delete;
  StbMemoryLimit& operator=(const StbMemoryLimit&) = delete;
};

}  // namespace opaline::core
