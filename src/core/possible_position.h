#pragma once

#include <cmath>

#include "opaline/types.h"

namespace opaline::core {

/// Whether a position, mm, is allowed: its coordinates are finite and below 1e18, so that squares
/// of distances are finite too. False for NaN.
inline bool isPossible(const Vec3& positionMm) {
  constexpr float limitMm = 1e18F;
  return std::abs(positionMm[0]) < limitMm && std::abs(positionMm[1]) < limitMm &&
         std::abs(positionMm[2]) < limitMm;
}

}  // namespace opaline::core
