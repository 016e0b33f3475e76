#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "atlas/awkward_meshes.h"
#include "surfels/subdivision.h"

namespace opaline::surfels::test {

using Point = std::array<double, 3>;

/// What a Surface points into.
struct Body {
  std::string name;
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> objectOfTriangle;
  std::size_t objects = 1;

  Surface surface() const { return {positions, triangles, objectOfTriangle}; }
  std::vector<double> spacing(double mm) const { return std::vector<double>(objects, mm); }
};

inline Body bodyOf(const awkward::Shape& shape) {
  Body body{shape.name, shape.positions, shape.triangles, shape.objects, 1};
  body.objectOfTriangle.resize(shape.triangles.size(), 0);
  for (const std::uint32_t object : body.objectOfTriangle)
    body.objects = std::max<std::size_t>(body.objects, object + 1);
  return body;
}

/// Objects 1 and 4 of five: the others have no triangles.
inline Body withEmptyObjects() {
  Body body = bodyOf(awkward::twoObjects());
  body.name = "with_empty_objects";
  for (std::uint32_t& object : body.objectOfTriangle) object = object == 0 ? 1 : 4;
  body.objects = 5;
  return body;
}

/// Each triangle an object.
inline Body crowd() {
  Body body = bodyOf(awkward::edgeFan());
  body.name = "crowd";
  for (std::uint32_t t = 0; t < body.triangles.size(); ++t) body.objectOfTriangle[t] = t;
  body.objects = body.triangles.size();
  return body;
}

/// One triangle, a hundred thousand times as long as wide.
inline Body sliver() {
  return {"sliver", {{0, 0, 0}, {10, 0, 0}, {4, 0.0001F, 0}}, {{0, 1, 2}}, {0}, 1};
}

inline std::vector<Body> allBodies() {
  std::vector<Body> bodies{withEmptyObjects(), crowd(), sliver()};
  for (const awkward::Shape& shape : awkward::all()) bodies.push_back(bodyOf(shape));
  return bodies;
}

inline Point cornerOf(const Body& body, std::uint32_t triangle, std::size_t corner) {
  const Vec3& p = body.positions[body.triangles[triangle][corner]];
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

inline double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Where the corners of a piece lie.
inline std::array<Point, 3> placesOf(const Body& body, const Piece& piece) {
  std::array<Point, 3> places{};
  const Point a = cornerOf(body, piece.triangle, 0);
  const Point b = cornerOf(body, piece.triangle, 1);
  const Point c = cornerOf(body, piece.triangle, 2);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto v = static_cast<double>(piece.corners[i][0]);
    const auto w = static_cast<double>(piece.corners[i][1]);
    for (std::size_t axis = 0; axis < 3; ++axis)
      places[i][axis] = (1 - v - w) * a[axis] + v * b[axis] + w * c[axis];
  }
  return places;
}

/// Edge of the square with the same mean square distance from its middle: h²/6 for a square, a 36th
/// of the sum of the squared edges for a triangle.
inline double sizeMm(const std::array<Point, 3>& corners) {
  double squares = 0;
  for (std::size_t i = 0; i < 3; ++i)
    squares += std::pow(distance(corners[i], corners[(i + 1) % 3]), 2);
  return std::sqrt(squares / 6);
}

}  // namespace opaline::surfels::test
