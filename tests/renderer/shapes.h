#pragma once

#include <array>
#include <cmath>

#include "opaline/scene.h"

namespace opaline::test {

/// Vectors for the tests' own arithmetic, in double precision.
using Vector = std::array<double, 3>;

inline Vector toVector(const float* v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}
inline Vector toVector(const Vec3& v) {
  return toVector(v.data());
}
inline Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector operator*(double s, const Vector& a) {
  return {s * a[0], s * a[1], s * a[2]};
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
inline Vector unit(const Vector& a) {
  return (1 / length(a)) * a;
}
inline Vec3 toVec3(const Vector& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

/// An icosahedron whose triangles are halved `levels` times and projected, with smooth normals:
/// 20·4^levels triangles, 10·4^levels + 2 vertices. With 5 levels no point is more than 0.03 % of
/// the radius below the sphere.
Mesh sphere(const Vec3& centreMm, float radiusMm, int levels = 5);

/// An open square sheet with this centre and half edges, of cells² squares. Its front is on the
/// side of the half edges' cross product.
Mesh sheet(const Vec3& centreMm, const Vec3& halfU, const Vec3& halfV, int cells = 24);

/// A closed box with flat normals, of cells² squares a side.
Mesh box(const Vec3& centreMm, const Vec3& halfMm, int cells = 16);

/// A surface in two parts: the triangles whose middle lies beyond the plane through the origin
/// perpendicular to a direction, and the others. Their borders coincide.
std::array<Mesh, 2> halvesOf(const Mesh& mesh, const Vector& direction);

/// The surface of two meshes.
Mesh together(const Mesh& a, const Mesh& b);

/// σ_s' and σ_a of marble and of skin1, Jensen et al. 2001.
Medium marble();
Medium skin();

/// A scene of one object, without light, seen from `cameraMm`. A ball of radius `reachMm` around
/// the origin fits the field of view.
Scene sceneOf(const Mesh& mesh, const Medium& medium, const Vec3& cameraMm, float reachMm);

}  // namespace opaline::test
