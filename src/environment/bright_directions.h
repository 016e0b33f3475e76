#pragma once

#include <array>
#include <cstddef>

#include "environment/sky.h"

namespace opaline {

/// Where the sky is brighter than on the mean: directions that each stand for as much of the light
/// above the mean.
struct BrightDirections {
  static constexpr std::size_t count = 256;

  std::array<Vec3, count> towards{};  ///< unit, neighbours near each other
  float mean = 0;                     ///< R + G + B of the sky's radiance
  float above = 0;  ///< integral of what is more than that; 0 where it is a small part of all light
};

BrightDirections brightDirectionsOf(const SkyParts& sky);

}  // namespace opaline
