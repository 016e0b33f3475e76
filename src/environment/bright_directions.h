#pragma once

#include <array>
#include <cstddef>

#include "environment/sky.h"

namespace opaline {

/// Directions where the sky is brighter than its mean. Each stands for the same amount of the light
/// above the mean.
struct BrightDirections {
  static constexpr std::size_t count = 256;

  std::array<Vec3, count> towards{};  ///< unit, neighbours near each other
  float mean = 0;                     ///< R + G + B of the sky's radiance
  float above = 0;  ///< integral of the radiance above the mean; 0 if it is a small part of all
                    ///< light
};

BrightDirections brightDirectionsOf(const SkyParts& sky);

}  // namespace opaline
