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

/// An icosahedron, divided that often and blown up to a sphere's area; every triangle is a cluster.
ClusteredBody sphere(double radiusMm, int divisions);

/// A ball with a hollow; every triangle is a cluster, those of the hollow come last.
ClusteredBody hollowSphere(double outerRadiusMm, double innerRadiusMm, int divisions);

/// From z = -thickness to 0, of square cells; those of the top come first, then the bottom.
ClusteredBody slab(double halfWidthMm, double thicknessMm, int cells);

}  // namespace opaline::test::boundary
