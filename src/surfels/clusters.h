#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "surfels/subdivision.h"
#include "surfels/surfels.h"
#include "surfels/tree.h"

namespace opaline::surfels {

/// Nodes of the tree of surfels that together hold each surfel once, and the tree above them, for
/// computations with fewer places than surfels. Clusters are smaller where the body is thin. An
/// object with clusters of both sides has those of its front first, then as many of its back in the
/// same order. Those of its lining come last, below a node of their own beside that of the others.
struct ClusterDivision {
  struct Cluster {
    std::uint32_t firstSurfel = 0;
    std::uint32_t endSurfel = 0;
    bool isBack = false;     ///< of the side from which the surface's triangles are clockwise
    double thicknessMm = 0;  ///< the least under its surfels, see surfels::thicknessMm

    bool operator==(const Cluster&) const = default;
  };
  std::vector<Cluster> clusters;
  std::vector<std::uint32_t> firstOfObject;  ///< first cluster; one more entry than there are
                                             ///< objects
  Tree tree;                                 ///< every leaf is one cluster
  std::size_t wanted = 0;                    ///< how many clusters there would be without a limit

  std::uint32_t count() const { return firstOfObject.back(); }
  /// Ratio of the clusters' edges to those that are wanted, by their numbers.
  double coarseness() const { return std::sqrt(static_cast<double>(wanted) / count()); }
};

/// Edge of a cluster, as a square, of an object that is about as thick as wide: a fraction of the
/// root of the object's area.
double usualClusterMm(double areaOfObjectMm2);

/// In place of the largest edge of an object's clusters: clusters are as large as its triangles
/// there.
constexpr double asItsTriangles = 0;

/// The clusters that are wanted for an object.
struct ClusterOrder {
  double largestMm = 0;    ///< edge, or asItsTriangles
  bool bothSides = false;  ///< its back has others than its front

  bool operator==(const ClusterOrder&) const = default;
};

/// Makes clusters of the usual size, but no larger than the order for their object says, nor than
/// the body is thick there. If these are more than `maxClusters`, nodes that are large compared
/// with the usual edge and the thickness are divided first, and demands of `largestMm` come after
/// those of shape. Every object has at least one cluster, or two with both sides.
ClusterDivision makeClusters(const core::RestSurface& surface, const SurfelDivision& surfels,
                             std::span<const ClusterOrder> orders, std::size_t maxClusters);

}  // namespace opaline::surfels
