#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "reference/geometry.h"

namespace opaline::test::boundary {

using reference::Vector;

/// Neighbouring triangles of a closed body that share one unknown of its boundary.
struct Cluster {
  Vector centroidMm{};            ///< by area
  double areaMm2 = 0;             ///< of all triangles
  Vector vectorAreaMm2{};         ///< sum of the triangles' areas times their normals
  Vector normal{};                ///< unit, of the vector area
  double discRadiusMm = 0;        ///< of a disc of that area
  reference::SurfacePoint start;  ///< on the triangle next to the centroid
};

struct TriangleClusters {
  std::vector<Cluster> list;
  std::vector<std::uint32_t> ofTriangle;

  std::size_t count() const { return list.size(); }
};

/// The triangles of the geometry's only body, joined as `ofTriangle` says.
TriangleClusters clustersOf(const reference::Geometry& geometry,
                            std::span<const std::uint32_t> ofTriangle);

/// The signed part of space that a cluster covers as seen from a point at an offset, positive from
/// inside. Nearby it is that of a disc, at most one half.
double coverage(const Cluster& of, const Vector& offset);

/// c of every cluster: the part of space that is inside, seen from its centroid, in [0, 1].
std::vector<double> insideOf(const TriangleClusters& clusters);

}  // namespace opaline::test::boundary
