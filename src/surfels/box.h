#pragma once

#include <algorithm>
#include <limits>

#include "surfels/vector.h"

namespace opaline::surfels {

/// An axis-aligned box around places, mm; empty at first.
struct Box {
  Vector low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
             std::numeric_limits<double>::infinity()};
  Vector high{-low[0], -low[1], -low[2]};

  void include(const Vector& place) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], place[axis]);
      high[axis] = std::max(high[axis], place[axis]);
    }
  }

  void include(const Box& box) {
    include(box.low);
    include(box.high);
  }

  /// Whether the boxes have a place in common.
  bool meets(const Box& other) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!(low[axis] <= other.high[axis] && other.low[axis] <= high[axis])) return false;
    return true;
  }

  bool contains(const Vector& place) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!(low[axis] <= place[axis] && place[axis] <= high[axis])) return false;
    return true;
  }

  double diagonal() const { return lengthOf(difference(high, low)); }
};

}  // namespace opaline::surfels
