#pragma once

#include <span>
#include <vector>

#include "opaline/compare.h"

namespace opaline::compare {

/// Weights at -radius … radius.
using Kernel = std::vector<double>;

/// Correlation with across(x) · down(y); beyond its borders the plane continues with its outermost
/// values. Both kernels have an odd number of weights.
Plane filtered(const Plane& plane, std::span<const double> across, std::span<const double> down);

}  // namespace opaline::compare
