#include "surfels/clusters.h"

#include <algorithm>
#include <cmath>

#include "surfels/thickness.h"

namespace opaline::surfels {

namespace {

// Clusters of an object whose parts are all thick.
constexpr double usualClusters = 3000;

// Thinner parts than this share of the usual edge are not followed further: their two sides are one
// place to light that leaves.
constexpr double leastPart = 0.25;

// How much coarser clusters become from one try to the next that fits the budget.
constexpr double coarserClusters = 1.05;

// What is below a node of the tree of surfels.
struct Below {
  std::uint32_t firstSurfel = 0;
  double areaMm2 = 0;
  double wantedMm = 0;  // edge of a cluster, mean over the area
};

class Divider {
 public:
  Divider(const core::RestSurface& surface, const SurfelDivision& surfels,
          std::span<const double> largestMm)
      : surfels_(surfels) {
    measure(surface, largestMm);
    below_.resize(surfels.tree.links.size());
    for (std::uint32_t node = 0; node < below_.size(); node = sum(node)) {
    }
  }

  ClusterDivision divide(double scale) {
    scale_ = scale;
    made_ = {};
    const std::vector<std::uint32_t>& roots = surfels_.tree.rootOfObject;
    for (std::size_t object = 0; object + 1 < roots.size(); ++object) {
      made_.firstOfObject.push_back(count());
      made_.tree.rootOfObject.push_back(nodeCount());
      if (roots[object] < roots[object + 1]) add(roots[object]);
    }
    made_.firstOfObject.push_back(count());
    made_.tree.rootOfObject.push_back(nodeCount());
    made_.firstSurfel.push_back(surfels_.count());
    made_.tree.sortByHeight();
    return std::move(made_);
  }

 private:
  std::uint32_t count() const { return static_cast<std::uint32_t>(made_.firstSurfel.size()); }
  std::uint32_t nodeCount() const { return static_cast<std::uint32_t>(made_.tree.links.size()); }

  void measure(const core::RestSurface& surface, std::span<const double> largestMm) {
    const std::vector<double> thickness = thicknessMm(surface, surfels_);
    areaMm2_.resize(surfels_.count());
    for (std::size_t surfel = 0; surfel < areaMm2_.size(); ++surfel)
      for (std::size_t i = 0; i < surfels_.piecesPerSurfel; ++i) {
        const Piece& piece = surfels_.pieces[surfel * surfels_.piecesPerSurfel + i];
        areaMm2_[surfel] += static_cast<double>(piece.fraction) * areaMm2(surface, piece.triangle);
      }
    wantedMm_.resize(surfels_.count());
    for (std::size_t object = 0; object + 1 < surfels_.firstOfObject.size(); ++object) {
      double area = 0;
      for (std::uint32_t i = surfels_.firstOfObject[object]; i < surfels_.firstOfObject[object + 1];
           ++i)
        area += areaMm2_[i];
      const double usual = std::min(usualClusterMm(area), largestMm[object]);
      for (std::uint32_t i = surfels_.firstOfObject[object]; i < surfels_.firstOfObject[object + 1];
           ++i)
        wantedMm_[i] = std::clamp(thickness[i], leastPart * usual, usual);
    }
  }

  // Returns the node after all that are below it.
  std::uint32_t sum(std::uint32_t node) {
    const NodeLink link = linkOf(surfels_.tree, node);
    Below below;
    double wanted = 0;
    if (link.leaf) {
      below.firstSurfel = link.first;
      for (std::uint32_t i = link.first; i < link.first + link.count; ++i) {
        below.areaMm2 += areaMm2_[i];
        wanted += areaMm2_[i] * wantedMm_[i];
      }
    } else {
      for (std::uint32_t child = node + 1; child < link.end;) {
        const std::uint32_t next = sum(child);
        if (child == node + 1) below.firstSurfel = below_[child].firstSurfel;
        below.areaMm2 += below_[child].areaMm2;
        wanted += below_[child].areaMm2 * below_[child].wantedMm;
        child = next;
      }
    }
    if (below.areaMm2 > 0) below.wantedMm = wanted / below.areaMm2;
    below_[node] = below;
    return link.end;
  }

  // The node or, where that is too large, what is below it.
  void add(std::uint32_t node) {
    const NodeLink link = linkOf(surfels_.tree, node);
    const Below& below = below_[node];
    const std::uint32_t made = nodeCount();
    made_.tree.links.push_back(0);
    if (link.leaf || std::sqrt(below.areaMm2) <= scale_ * below.wantedMm) {
      made_.tree.links[made] = Tree::leafBit | Tree::setBit | count();
      made_.firstSurfel.push_back(below.firstSurfel);
      return;
    }
    for (std::uint32_t child = node + 1; child < link.end; child = linkOf(surfels_.tree, child).end)
      add(child);
    made_.tree.links[made] = Tree::setBit | nodeCount();
  }

  const SurfelDivision& surfels_;
  std::vector<double> areaMm2_;   // of each surfel
  std::vector<double> wantedMm_;  // edge of a cluster there
  std::vector<Below> below_;
  double scale_ = 1;
  ClusterDivision made_;
};

}  // namespace

double usualClusterMm(double areaOfObjectMm2) {
  return std::sqrt(areaOfObjectMm2 / usualClusters);
}

ClusterDivision makeClusters(const core::RestSurface& surface, const SurfelDivision& surfels,
                             std::span<const double> largestMm, std::size_t maxClusters) {
  Divider divider(surface, surfels, largestMm);
  double scale = 1;
  ClusterDivision clusters = divider.divide(scale);
  while (clusters.count() > maxClusters && clusters.count() > clusters.tree.rootOfObject.size()) {
    // Their number goes with the square of the scale.
    scale *= std::max(
        coarserClusters,
        std::sqrt(static_cast<double>(clusters.count()) / static_cast<double>(maxClusters)) * 0.9);
    clusters = divider.divide(scale);
  }
  clusters.coarseness = scale;
  return clusters;
}

}  // namespace opaline::surfels
