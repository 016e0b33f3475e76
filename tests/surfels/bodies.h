#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "awkward_meshes.h"
#include "surfels/subdivision.h"

namespace opaline::surfels::test {

using Point = std::array<double, 3>;

/// The data to which a Surface refers.
struct Body {
  std::string name;
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> objectOfTriangle;
  std::size_t objects = 1;

  core::RestSurface surface() const { return {positions, triangles, objectOfTriangle}; }
  std::vector<double> spacing(double mm) const { return std::vector<double>(objects, mm); }
};

inline Body bodyOf(const awkward::Shape& shape) {
  Body body{shape.name, shape.positions, shape.triangles, shape.objects, 1};
  body.objectOfTriangle.resize(shape.triangles.size(), 0);
  for (const std::uint32_t object : body.objectOfTriangle)
    body.objects = std::max<std::size_t>(body.objects, object + 1);
  return body;
}

/// Objects 1 and 4 of five; the others have no triangles.
inline Body withEmptyObjects() {
  Body body = bodyOf(awkward::twoObjects());
  body.name = "with_empty_objects";
  for (std::uint32_t& object : body.objectOfTriangle) object = object == 0 ? 1 : 4;
  body.objects = 5;
  return body;
}

/// Every triangle is an object.
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

/// Eight corners, given low then high along y, each counterclockwise from above.
inline Body hexahedron(const std::string& name, const std::array<Vec3, 8>& corners) {
  Body body{name, {corners.begin(), corners.end()}, {}, {}, 1};
  constexpr std::array<std::array<std::uint32_t, 4>, 6> faces{
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  for (const auto& face : faces) {
    body.triangles.push_back({face[0], face[1], face[2]});
    body.triangles.push_back({face[0], face[2], face[3]});
  }
  body.objectOfTriangle.assign(body.triangles.size(), 0);
  return body;
}

/// A box from the origin to that corner.
inline Body box(float x, float y, float z) {
  return hexahedron(
      "box",
      {{{0, 0, 0}, {0, 0, z}, {x, 0, z}, {x, 0, 0}, {0, y, 0}, {0, y, z}, {x, y, z}, {x, y, 0}}});
}

/// A box whose top slopes from `low` at x = 0 to `high`.
inline Body wedge(float x, float low, float high, float z) {
  Body body = box(x, 0, z);
  body.name = "wedge";
  for (const std::size_t i : {4U, 5U}) body.positions[i][1] = low;
  for (const std::size_t i : {6U, 7U}) body.positions[i][1] = high;
  return body;
}

/// Both bodies, each with objects of its own.
inline Body together(const Body& a, const Body& b) {
  Body body = a;
  body.name += "_and_" + b.name;
  const auto vertices = static_cast<std::uint32_t>(a.positions.size());
  body.positions.insert(body.positions.end(), b.positions.begin(), b.positions.end());
  for (const Triangle& t : b.triangles)
    body.triangles.push_back({t[0] + vertices, t[1] + vertices, t[2] + vertices});
  for (const std::uint32_t object : b.objectOfTriangle)
    body.objectOfTriangle.push_back(object + static_cast<std::uint32_t>(a.objects));
  body.objects += b.objects;
  return body;
}

/// A sphere that is hollow up to that part of its radius.
inline Body hollowSphere(float inner) {
  Body body = bodyOf(awkward::sphere());
  body.name = "hollow_sphere";
  const auto vertices = static_cast<std::uint32_t>(body.positions.size());
  const std::size_t outside = body.triangles.size();
  for (std::uint32_t i = 0; i < vertices; ++i) {
    const Vec3 p = body.positions[i];
    body.positions.push_back({inner * p[0], inner * p[1], inner * p[2]});
  }
  for (std::size_t t = 0; t < outside; ++t) {
    const Triangle outer = body.triangles[t];
    body.triangles.push_back({outer[0] + vertices, outer[2] + vertices, outer[1] + vertices});
    body.objectOfTriangle.push_back(body.objectOfTriangle[t]);
  }
  return body;
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
