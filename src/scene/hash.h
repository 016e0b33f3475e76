#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace opaline::scene {

/// Mixes one more value into a hash. The start may be any number.
inline void mix(std::uint64_t& hash, std::uint64_t value) {
  hash = (hash ^ value) * 0x9E3779B97F4A7C15U;
  hash ^= hash >> 29U;
}

/// Hashes arrays of numbers, for keys of unordered maps.
struct HashOfNumbers {
  template <typename Number, std::size_t Count>
  std::size_t operator()(const std::array<Number, Count>& numbers) const {
    std::uint64_t hash = 0;
    for (const Number number : numbers) mix(hash, static_cast<std::uint64_t>(number));
    return static_cast<std::size_t>(hash);
  }
};

}  // namespace opaline::scene
