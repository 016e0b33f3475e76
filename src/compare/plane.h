#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace opaline::compare {

/// One number a pixel, rows from top to bottom.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<float> values;

  Plane() = default;
  Plane(int widthPixels, int heightPixels)
      : width(widthPixels),
        height(heightPixels),
        values(static_cast<std::size_t>(widthPixels) * static_cast<std::size_t>(heightPixels)) {}
};

/// Weights at -radius … radius.
using Kernel = std::vector<double>;

/// Correlation with across(x) · down(y); beyond its borders the plane goes on as it ends there.
/// Both kernels have an odd number of weights.
Plane filtered(const Plane& plane, std::span<const double> across, std::span<const double> down);

}  // namespace opaline::compare
