#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "opaline/types.h"

namespace opaline::surfels {

using Vector = std::array<double, 3>;

inline Vector vectorOf(const Vec3& v) {
  return {v[0], v[1], v[2]};
}

inline Vector difference(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline double lengthOf(const Vector& v) {
  return std::sqrt(dot(v, v));
}

inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline void addTimes(double weight, const Vector& part, Vector& sum) {
  for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += weight * part[axis];
}

}  // namespace opaline::surfels
