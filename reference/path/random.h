#pragma once

#include <cstdint>

namespace opaline::reference {

/// xoshiro256++ (Blackman and Vigna 2021), seeded by splitmix64 from a seed and the number of a
/// particle. Every particle thus has its own sequence, whichever thread traces it.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t particle) {
    std::uint64_t state = seed * 0x9E3779B97F4A7C15U + particle * 0xD1342543DE82EF95U;
    for (std::uint64_t& word : state_) {
      state += 0x9E3779B97F4A7C15U;
      std::uint64_t z = state;
      z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
      z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
      word = z ^ (z >> 31U);
    }
  }

  /// In (0, 1): never 0, so that the logarithm is finite.
  double operator()() {
    const std::uint64_t result = rotated(state_[0] + state_[3], 23) + state_[0];
    const std::uint64_t t = state_[1] << 17U;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= t;
    state_[3] = rotated(state_[3], 45);
    return (static_cast<double>(result >> 11U) + 0.5) * 0x1.0p-53;
  }

 private:
  static std::uint64_t rotated(std::uint64_t x, unsigned by) {
    return (x << by) | (x >> (64U - by));
  }

  std::uint64_t state_[4];
};

}  // namespace opaline::reference
