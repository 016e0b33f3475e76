#include "scene/mesh/tangents.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "scene/vector_math.h"

namespace opaline::scene {

namespace {

/// The edges of a triangle from its first corner.
struct Edges {
  Double3 toSecond;
  Double3 toThird;
};

Edges edgesOf(const Mesh& mesh, const Triangle& t) {
  const Double3 first = toDouble(mesh.positionsMm[t[0]]);
  return {toDouble(mesh.positionsMm[t[1]]) - first, toDouble(mesh.positionsMm[t[2]]) - first};
}

/// The direction in which the first coordinate grows, and twice the area in the texture, whose rows
/// go down.
struct Growth {
  Double3 along{};
  double area = 0;
};

Growth growthOf(const std::vector<Vec2>& places, const Triangle& t, const Edges& edges) {
  const auto offset = [&](std::size_t corner, std::size_t axis) {
    return double{places[t[corner]][axis]} - double{places[t[0]][axis]};
  };
  const double area = offset(1, 0) * offset(2, 1) - offset(2, 0) * offset(1, 1);
  const double sign = area < 0 ? -1 : 1;
  return {sign * (offset(2, 1) * edges.toSecond - offset(1, 1) * edges.toThird), area};
}

Double3 inPlane(const Double3& v, const Double3& normal) {
  const Double3 flat = v - dot(v, normal) * normal;
  const double size = length(flat);
  return size > 0 ? (1 / size) * flat : Double3{};
}

double angleAt(const Mesh& mesh, const Triangle& t, std::size_t corner, const Double3& normal) {
  const Double3 at = toDouble(mesh.positionsMm[t[corner]]);
  const Double3 next = inPlane(toDouble(mesh.positionsMm[t[(corner + 1) % 3]]) - at, normal);
  const Double3 last = inPlane(toDouble(mesh.positionsMm[t[(corner + 2) % 3]]) - at, normal);
  return std::acos(std::clamp(dot(next, last), -1.0, 1.0));
}

/// The projection of `v` on the triangle's plane, in terms of its edges.
Vec2 byEdges(const Double3& v, const Edges& edges) {
  const double aa = dot(edges.toSecond, edges.toSecond);
  const double ab = dot(edges.toSecond, edges.toThird);
  const double bb = dot(edges.toThird, edges.toThird);
  const double determinant = aa * bb - ab * ab;
  if (!(determinant > 0)) return {0, 0};
  const double a = dot(v, edges.toSecond);
  const double b = dot(v, edges.toThird);
  return {static_cast<float>((a * bb - b * ab) / determinant),
          static_cast<float>((b * aa - a * ab) / determinant)};
}

}  // namespace

std::vector<TriangleTangents> tangentsOf(const Mesh& mesh, std::size_t coordinates) {
  std::vector<TriangleTangents> tangents(mesh.triangles.size());
  const std::vector<Vec2>& places = mesh.textureCoordinates[coordinates];
  if (places.empty()) return tangents;
  // One set of sums for each handedness.
  std::array<std::vector<Double3>, 2> sums;
  sums.fill(std::vector<Double3>(mesh.positionsMm.size()));
  const auto handOf = [](double area) { return area < 0 ? std::size_t{1} : std::size_t{0}; };
  for (const Triangle& t : mesh.triangles) {
    const Growth growth = growthOf(places, t, edgesOf(mesh, t));
    if (growth.area == 0) continue;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Double3 normal = toDouble(mesh.normals[t[corner]]);
      Double3& sum = sums[handOf(growth.area)][t[corner]];
      sum = sum + angleAt(mesh, t, corner, normal) * inPlane(growth.along, normal);
    }
  }
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    const Edges edges = edgesOf(mesh, t);
    const double area = growthOf(places, t, edges).area;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Double3 normal = toDouble(mesh.normals[t[corner]]);
      tangents[i].corners[corner] = byEdges(inPlane(sums[handOf(area)][t[corner]], normal), edges);
    }
    tangents[i].side = area < 0 ? 1.0F : -1.0F;
  }
  return tangents;
}

}  // namespace opaline::scene
