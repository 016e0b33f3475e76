#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "opaline/types.h"

namespace opaline::reference {

/// Points in mm, and directions. The same type as in the deformed meshes.
using Vector = std::array<double, 3>;

/// A light quantity per channel.
using Colour = std::array<double, 3>;

inline Vector toVector(const Vec3& v) {
  return {double{v[0]}, double{v[1]}, double{v[2]}};
}
inline Vec3 toFloat(const Vector& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}
inline Colour toColour(const Rgb& rgb) {
  return toVector(rgb);
}
inline Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector operator-(const Vector& a) {
  return {-a[0], -a[1], -a[2]};
}
inline Vector operator*(double s, const Vector& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
inline Vector& operator+=(Vector& a, const Vector& b) {
  return a = a + b;
}
inline Colour product(const Colour& a, const Colour& b) {
  return {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
}
inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Vector& a) {
  return std::sqrt(dot(a, a));
}
/// The direction of a vector, or `other` if it has none.
inline Vector unitOr(const Vector& a, const Vector& other) {
  const double size = length(a);
  return size > 0 && std::isfinite(size) ? (1 / size) * a : other;
}

/// Two directions orthogonal to a unit direction and each other, forming a right-handed frame with
/// it (Duff et al. 2017).
inline std::array<Vector, 2> across(const Vector& n) {
  const double sign = std::copysign(1.0, n[2]);
  const double a = -1 / (sign + n[2]);
  const double b = n[0] * n[1] * a;
  return {Vector{1 + sign * n[0] * n[0] * a, sign * b, -sign * n[0]},
          Vector{b, sign + n[1] * n[1] * a, -n[1]}};
}

/// The unit direction at that cosine to a unit axis, rotated by `angle` about it.
inline Vector around(const Vector& axis, double cosine, double angle) {
  const auto [x, y] = across(axis);
  const double sine = std::sqrt(std::max(1 - cosine * cosine, 0.0));
  return unitOr(sine * std::cos(angle) * x + sine * std::sin(angle) * y + cosine * axis, axis);
}

}  // namespace opaline::reference
