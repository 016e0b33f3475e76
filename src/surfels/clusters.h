#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "surfels/subdivision.h"
#include "surfels/surfels.h"
#include "surfels/tree.h"

namespace opaline::surfels {

/// Nodes of the tree of surfels that together hold each surfel once, and the tree above them: what
/// needs fewer places than there are surfels. They follow the surface where it is thin.
struct ClusterDivision {
  std::vector<std::uint32_t> firstSurfel;    ///< one more than there are clusters
  std::vector<std::uint32_t> firstOfObject;  ///< cluster; one more than there are objects
  Tree tree;                                 ///< every leaf is one cluster
  double coarseness = 1;  ///< edges over those of clusters without a limit to their number

  std::uint32_t count() const { return firstOfObject.back(); }
};

/// Edge of a cluster as a square, of an object as a whole and where it is as thick as wide: a part
/// of the root of its area.
double usualClusterMm(double areaOfObjectMm2);

/// As large as usual, no larger than `largestMm`, one an object, nor than the body is thick there,
/// unless that makes more than `maxClusters`: then all are coarser by the same factor. Every object
/// has one at least.
ClusterDivision makeClusters(const core::RestSurface& surface, const SurfelDivision& surfels,
                             std::span<const double> largestMm, std::size_t maxClusters);

}  // namespace opaline::surfels
