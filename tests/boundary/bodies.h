#pragma once

#include <cstdint>
#include <vector>

#include "reference/scene.h"

namespace opaline::test::boundary {

/// A closed body and the triangles of each of its clusters.
struct ClusteredBody {
  reference::Scene scene;
  std::vector<std::uint32_t> clusterOfTriangle;
};

/// An icosahedron, divided `divisions` times and scaled to a sphere's area; every triangle is a
/// cluster.
ClusteredBody sphere(double radiusMm, int divisions);

/// A ball with a hollow; every triangle is a cluster, with those of the hollow last.
ClusteredBody hollowSphere(double outerRadiusMm, double innerRadiusMm, int divisions);

/// A slab of square cells from z = -thickness to 0; the top's come first, then the bottom's.
ClusteredBody slab(double halfWidthMm, double thicknessMm, int cells);

}  // namespace opaline::test::boundary
