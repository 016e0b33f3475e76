#pragma once

#include <algorithm>
#include <cmath>

#include "opaline/options/range.h"
#include "opaline/types.h"

namespace opaline::options {

/// What light and glowing surfaces may give off.
constexpr Range power{0, 1e30};

/// Whether all coordinates are finite.
inline bool isFinite(const Vec3& v) {
  return std::all_of(v.begin(), v.end(), [](float x) { return std::isfinite(x); });
}

}  // namespace opaline::options
