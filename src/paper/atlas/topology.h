#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "paper/atlas/atlas.h"

namespace opaline::atlas {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

using Point3 = std::array<double, 3>;

/// What segmentation and flattening need to know of a surface, one entry per triangle. Edge i of a
/// triangle runs from corner i to corner i+1.
struct Topology {
  std::vector<Triangle> triangles;                       ///< of welded vertices
  std::vector<Point3> positions;                         ///< of welded vertices, mm
  std::vector<std::array<std::uint32_t, 3>> neighbours;  ///< across each edge, or none
  std::vector<Point3> normals;                           ///< unit; zero for degenerate triangles
  std::vector<Point3> centroids;
  std::vector<double> areas;
  std::vector<bool> degenerate;  ///< too thin to be flattened
};

/// Two triangles are neighbours where exactly two share an edge, run along it in opposite
/// directions, belong to one object and are not degenerate. Everything else is a border.
Topology makeTopology(const core::RestSurface& surface);

Point3 subtract(const Point3& a, const Point3& b);
Point3 cross(const Point3& a, const Point3& b);
double dot(const Point3& a, const Point3& b);
double length(const Point3& a);

}  // namespace opaline::atlas
