#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "builtin/builtin.h"
#include "opaline/scene.h"
#include "renderer/shapes.h"
#include "surfels/surfels.h"

namespace opaline::passes::test {

using opaline::test::cross;
using opaline::test::Vector;

/// A surface at rest, which is divided, and the current places of its vertices.
struct Body {
  std::vector<Vec3> rest;
  std::vector<Vec3> moved;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> objectOfTriangle;
  std::uint32_t objects = 0;

  core::RestSurface surface() const { return {rest, triangles, objectOfTriangle}; }
  Vector place(std::uint32_t vertex) const { return opaline::test::toVector(moved[vertex]); }

  void add(const Mesh& mesh) {
    const auto first = static_cast<std::uint32_t>(rest.size());
    rest.insert(rest.end(), mesh.positionsMm.begin(), mesh.positionsMm.end());
    for (const Triangle& t : mesh.triangles) {
      triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
      objectOfTriangle.push_back(objects);
    }
    ++objects;
    moved = rest;
  }
  template <typename Move>
  void move(const Move& to) {
    for (std::size_t i = 0; i < rest.size(); ++i)
      moved[i] = opaline::test::toVec3(to(opaline::test::toVector(rest[i])));
  }
  /// Largest coordinate, mm.
  double reachMm() const {
    float reach = 0;
    for (const Vec3& p : moved)
      for (const float x : p) reach = std::max(reach, std::abs(x));
    return static_cast<double>(reach);
  }
};

inline Body bodyOf(const Mesh& mesh) {
  Body body;
  body.add(mesh);
  return body;
}

/// Twists about the y axis by half a turn in 40 mm.
inline Vector twisted(const Vector& p) {
  const double angle = p[1] * 3.14 / 40;
  return {std::cos(angle) * p[0] + std::sin(angle) * p[2], p[1],
          std::cos(angle) * p[2] - std::sin(angle) * p[0]};
}

/// A ray as shaders get it: distances are in lengths of the direction.
struct Ray {
  std::array<float, 3> origin{};
  float from = 0;
  std::array<float, 3> direction{};
  float to = 1e6F;
};

/// Where a ray meets a triangle's plane, and the distance inside the nearest edge, mm.
struct PlaneHit {
  double distance = 0;
  double insideMm = -std::numeric_limits<double>::infinity();
  double cosine = 0;
};

inline PlaneHit meet(const Ray& ray, const std::array<Vector, 3>& corners) {
  using namespace opaline::test;
  const Vector origin = toVector(ray.origin.data());
  const Vector direction = toVector(ray.direction.data());
  const Vector normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double along = dot(normal, direction);
  PlaneHit hit;
  if (along == 0) return hit;
  hit.distance = dot(normal, corners[0] - origin) / along;
  hit.cosine = std::abs(along) / (length(normal) * length(direction));
  const Vector at = origin + hit.distance * direction;
  hit.insideMm = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector edge = corners[(i + 1) % 3] - corners[i];
    const double inside =
        dot(cross(normal, edge), at - corners[i]) / (length(normal) * length(edge));
    hit.insideMm = std::min(hit.insideMm, inside);
  }
  return hit;
}

/// The nearest hit that exact arithmetic may find if rounding moves edges by `roundingMm`.
struct Expected {
  double earliest = std::numeric_limits<double>::infinity();
  double latest = std::numeric_limits<double>::infinity();
};

inline Expected expectedHit(const Body& body, const Ray& ray, double roundingMm,
                            std::uint32_t firstObject, std::uint32_t endObject) {
  Expected expected;
  const double lengthMm = opaline::test::length(opaline::test::toVector(ray.direction.data()));
  for (std::size_t t = 0; t < body.triangles.size(); ++t) {
    if (body.objectOfTriangle[t] < firstObject || body.objectOfTriangle[t] >= endObject) continue;
    const Triangle& triangle = body.triangles[t];
    const PlaneHit hit =
        meet(ray, {body.place(triangle[0]), body.place(triangle[1]), body.place(triangle[2])});
    const double reach = 2 * roundingMm / std::max(hit.cosine, 1e-12);
    if (hit.insideMm < -reach) continue;
    const double rounding = reach / lengthMm;
    const auto from = static_cast<double>(ray.from);
    const auto to = static_cast<double>(ray.to);
    if (hit.distance + rounding > from && hit.distance - rounding < to)
      expected.earliest = std::min(expected.earliest, hit.distance - rounding);
    if (hit.insideMm > reach && hit.distance - rounding > from && hit.distance + rounding < to)
      expected.latest = std::min(expected.latest, hit.distance + rounding);
  }
  return expected;
}

}  // namespace opaline::passes::test
