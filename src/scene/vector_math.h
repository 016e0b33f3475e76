#pragma once

#include <array>
#include <cmath>

#include "opaline/types.h"

namespace opaline::scene {

/// Double, because geometric decisions need its precision.
using Double3 = std::array<double, 3>;

inline Double3 toDouble(const Vec3& v) {
  return {double{v[0]}, double{v[1]}, double{v[2]}};
}
inline Vec3 toFloat(const Double3& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}
inline Double3 operator+(const Double3& a, const Double3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Double3 operator-(const Double3& a, const Double3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Double3 operator*(double s, const Double3& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
inline double dot(const Double3& a, const Double3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Double3 cross(const Double3& a, const Double3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Double3& a) {
  return std::sqrt(dot(a, a));
}

inline Double3 unit(const Double3& a) {
  return (1 / length(a)) * a;
}
inline bool isFinite(const Double3& a) {
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}
inline bool isFinite(const Vec3& a) {
  return isFinite(toDouble(a));
}

/// Twice the area times the normal, by the right-hand rule.
inline Double3 areaVector(const Double3& a, const Double3& b, const Double3& c) {
  return cross(b - a, c - a);
}

/// The angle at p between the directions to q and r, in radians.
inline double angleAt(const Double3& p, const Double3& q, const Double3& r) {
  return std::atan2(length(cross(q - p, r - p)), dot(q - p, r - p));
}

}  // namespace opaline::scene
