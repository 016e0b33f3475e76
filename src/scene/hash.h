#pragma once

#include <cstdint>

namespace opaline::scene {

/// Takes one more value into a hash, whose start is any number.
inline void mix(std::uint64_t& hash, std::uint64_t value) {
  hash = (hash ^ value) * 0x9E3779B97F4A7C15U;
  hash ^= hash >> 29U;
}

}  // namespace opaline::scene
