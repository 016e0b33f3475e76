#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reference/scene.h"

namespace opaline::reference {

/// A lower bound in mm on the distance from a point inside a medium to the surface, read from a
/// grid: a shorter step needs no ray. It is the exact distance transform of the voxels that
/// triangles touch (Felzenszwalb and Huttenlocher 2012), less the uncertainty within a voxel.
class DistanceBound {
 public:
  explicit DistanceBound(const Scene& scene);

  /// 0 near the surface and outside the grid.
  double operator()(const Vector& point) const {
    std::size_t index = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double place = (point[axis] - originMm_[axis]) * voxelsPerMm_;
      if (!(place >= 0 && place < static_cast<double>(size_[axis]))) return 0;
      index = index * size_[axis] + static_cast<std::size_t>(place);
    }
    return static_cast<double>(boundMm_[index]);
  }

 private:
  Vector originMm_{};
  double voxelsPerMm_ = 1;
  std::array<std::size_t, 3> size_{1, 1, 1};
  std::vector<float> boundMm_;
};

}  // namespace opaline::reference
