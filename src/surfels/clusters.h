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

/// Nodes of the tree of surfels that together hold each surfel once, and the tree above them: what
/// needs fewer places than there are surfels. They follow the surface where it is thin. An object
/// that has clusters of both sides has those of its front first, and as many of its back in equal
/// order. Those of its lining come last, below a node of their own beside that of the others.
struct ClusterDivision {
  struct Cluster {
    std::uint32_t firstSurfel = 0;
    std::uint32_t endSurfel = 0;
    bool isBack = false;  ///< of the side from which the surface's triangles go round clockwise

    bool operator==(const Cluster&) const = default;
  };
  std::vector<Cluster> clusters;
  std::vector<std::uint32_t> firstOfObject;  ///< cluster; one more than there are objects
  Tree tree;                                 ///< every leaf is one cluster
  std::size_t wanted = 0;  ///< how many there would be without a limit to their number

  std::uint32_t count() const { return firstOfObject.back(); }
  /// Edges over those that are wanted, by their number.
  double coarseness() const { return std::sqrt(static_cast<double>(wanted) / count()); }
};

/// Edge of a cluster as a square, of an object as a whole and where it is as thick as wide: a part
/// of the root of its area.
double usualClusterMm(double areaOfObjectMm2);

/// In place of the largest edge of an object's clusters: they are as large as its triangles are
/// there.
constexpr double asItsTriangles = 0;

/// What an object's clusters are to be like.
struct ClusterOrder {
  double largestMm = 0;    ///< edge, or asItsTriangles
  bool bothSides = false;  ///< its back has others than its front

  bool operator==(const ClusterOrder&) const = default;
};

/// As large as usual, no larger than ordered, one order an object, nor than the body is thick
/// there. Where that makes more than `maxClusters`, those go first to what is large against the
/// usual edge and against the thickness, and what `largestMm` asks for waits until shapes have all
/// that they ask for. Every object has one at least, or two.
ClusterDivision makeClusters(const core::RestSurface& surface, const SurfelDivision& surfels,
                             std::span<const ClusterOrder> orders, std::size_t maxClusters);

}  // namespace opaline::surfels
