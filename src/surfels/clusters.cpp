#include "surfels/clusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "surfels/thickness.h"
#include "surfels/vector.h"

namespace opaline::surfels {

namespace {

// The number of clusters of an object whose parts are all thick.
constexpr double usualClusters = 3000;

// Clusters do not become smaller for parts thinner than this share of the usual edge: light that
// leaves does not tell their two sides apart.
constexpr double leastPart = 0.25;

// Cosine to a node's mean normal below which a surfel lies on the other side of the body, and the
// share of the node's area there from which the node is of both sides.
constexpr double otherSide = -0.3;
constexpr double leastOfOtherSide = 0.01;

// From this distance on, in edges of the node, two sides do not count as one place as the sides of
// a rim do.
constexpr double apartInEdges = 1.5;

// If the budget does not suffice, nodes count as larger by this power of the ratio of their edge to
// the thickness. With 1, bear and bunny have a quarter more error with 64 clusters; with 0, up to
// 1.6 times as much error with 128 to 512.
constexpr double thinPower = 0.75;

// Ratio of a cluster's edge to a triangle's where two triangles that form a square are one cluster.
constexpr double edgeOverTriangle = 1.5;

// Edges of an object's clusters, mm.
struct Edges {
  double usual = 0;
  double largest = 0;
  std::size_t sides = 1;  // that have clusters of their own

  bool areAsItsTriangles() const { return largest == asItsTriangles; }
};

// A surfel's shape in the rest pose.
struct SurfelShape {
  double areaMm2 = 0;
  Vector vectorAreaMm2{};
  Vector middleMm{};
};

// What is below a node of the tree of surfels.
struct Below {
  std::uint32_t firstSurfel = 0;
  std::uint32_t endSurfel = 0;
  std::uint32_t object = 0;
  double areaMm2 = 0;
  // Means over the area or, where clusters are as large as triangles, over surfels: otherwise one
  // large triangle would hide that others beside it are small.
  double weight = 0;
  double wantedMm = 0;       // edge of a cluster
  double ofShapeMm = 0;      // the same, as the shape alone demands it, without the medium
  double thinnessPerMm = 0;  // 1 over the thickness

  double edgeMm() const { return std::sqrt(areaMm2); }
  bool isTooLarge() const { return edgeMm() > wantedMm; }
};

// If the budget suffices only for some of many equal nodes, those that are divided have to lie
// evenly between the others: a plate with one half finer than the other would be visible. Nodes are
// numbered in spatial order, so steps of the golden ratio achieve that (Knuth 1973, 6.4). No two
// nodes have the same number.
std::uint32_t evenOrder(std::uint32_t node) {
  return node * 2654435769U;
}

// How urgently a node that is too large for a cluster needs to be divided; the largest is the most
// urgent. Shape comes first: two sides in one cluster cause far more error than a size of many mean
// free paths.
struct Need {
  bool forShape = false;
  int excess = 0;  ///< of the edge, as twice its binary logarithm, which one division reduces by
                   ///< one
  std::uint32_t node = 0;

  bool operator<(const Need& other) const {
    return std::tuple(forShape, excess, evenOrder(node)) <
           std::tuple(other.forShape, other.excess, evenOrder(other.node));
  }
};

class Divider {
 public:
  Divider(const core::RestSurface& surface, const SurfelDivision& surfels,
          std::span<const ClusterOrder> orders)
      : surfels_(surfels) {
    measure(surface, orders);
    below_.resize(surfels_.tree.links.size());
    const std::vector<std::uint32_t>& roots = surfels_.tree.rootOfObject;
    for (std::uint32_t object = 0; object + 1 < roots.size(); ++object)
      for (std::uint32_t node = roots[object]; node < roots[object + 1];) node = sum(node, object);
    for (Below& below : below_)
      if (below.edgeMm() <= edges_[below.object].usual && isOfBothSides(below)) divide(below);
  }

  // Opens nodes, the most urgent first, until none is too large for a cluster or there would be
  // more than `maxClusters`. Returns the number of clusters.
  std::size_t open(std::size_t maxClusters) {
    opened_.assign(below_.size(), false);
    std::size_t clusters = 0;
    std::priority_queue<Need> needs;
    const auto take = [&](std::uint32_t node) {
      clusters += sidesOf(node);
      if (!linkOf(surfels_.tree, node).leaf && below_[node].isTooLarge()) needs.push(needOf(node));
    };
    const std::vector<std::uint32_t>& roots = surfels_.tree.rootOfObject;
    for (std::size_t object = 0; object + 1 < roots.size(); ++object) forEachRoot(object, take);
    while (!needs.empty()) {
      const std::uint32_t node = needs.top().node;
      std::size_t children = 0;
      forEachChild(node, [&](std::uint32_t) { ++children; });
      if (clusters + (children - 1) * sidesOf(node) > maxClusters) break;
      needs.pop();
      opened_[node] = true;
      clusters -= sidesOf(node);
      forEachChild(node, take);
    }
    return clusters;
  }

  // Makes clusters of the nodes that are not opened.
  ClusterDivision collect() {
    made_ = {};
    const std::vector<std::uint32_t>& roots = surfels_.tree.rootOfObject;
    for (std::size_t object = 0; object + 1 < roots.size(); ++object) {
      made_.firstOfObject.push_back(count());
      made_.tree.rootOfObject.push_back(nodeCount());
      if (roots[object] == roots[object + 1]) continue;
      if (edges_[object].sides == 1)
        forEachRoot(object, [&](std::uint32_t root) { add(root, false); });
      else
        addBothSides(roots[object]);
    }
    made_.firstOfObject.push_back(count());
    made_.tree.rootOfObject.push_back(nodeCount());
    return std::move(made_);
  }

 private:
  std::uint32_t count() const { return static_cast<std::uint32_t>(made_.clusters.size()); }
  std::uint32_t nodeCount() const { return static_cast<std::uint32_t>(made_.tree.links.size()); }

  std::size_t sidesOf(std::uint32_t node) const { return edges_[below_[node].object].sides; }

  void measure(const core::RestSurface& surface, std::span<const ClusterOrder> orders) {
    thicknessMm_ = thicknessMm(surface, surfels_);
    shapes_.reserve(surfels_.count());
    for (std::uint32_t surfel = 0; surfel < surfels_.count(); ++surfel)
      shapes_.push_back(shapeOf(surface, surfel));
    for (std::size_t object = 0; object + 1 < surfels_.firstOfObject.size(); ++object) {
      double area = 0;
      for (std::uint32_t i = surfels_.firstOfObject[object];
           i < surfels_.firstLiningOfObject[object]; ++i)
        area += shapes_[i].areaMm2;
      edges_.push_back({usualClusterMm(area), orders[object].largestMm,
                        orders[object].bothSides ? std::size_t{2} : std::size_t{1}});
    }
  }

  SurfelShape shapeOf(const core::RestSurface& surface, std::uint32_t surfel) const {
    SurfelShape shape;
    for (std::size_t i = 0; i < surfels_.piecesPerSurfel; ++i) {
      const Piece& piece = surfels_.pieces[std::size_t{surfel} * surfels_.piecesPerSurfel + i];
      const auto fraction = static_cast<double>(piece.fraction);
      const double area = areaMm2(surface, piece);
      shape.areaMm2 += area;
      addTimes(0.5 * fraction, crossOf(surface, piece.triangle), shape.vectorAreaMm2);
      const Vec3 middle = middleOfMm(surface, piece);
      addTimes(area, {middle[0], middle[1], middle[2]}, shape.middleMm);
    }
    if (shape.areaMm2 > 0)
      for (double& axis : shape.middleMm) axis /= shape.areaMm2;
    return shape;
  }

  // Whether a part of the node faces away from the rest and lies far from it.
  bool isOfBothSides(const Below& below) const {
    Vector mean{};
    for (std::uint32_t i = below.firstSurfel; i < below.endSurfel; ++i)
      addTimes(1, shapes_[i].vectorAreaMm2, mean);
    const double most = otherSide * lengthOf(mean);
    std::array<double, 2> areaMm2{};
    std::array<Vector, 2> middleMm{};
    for (std::uint32_t i = below.firstSurfel; i < below.endSurfel; ++i) {
      const SurfelShape& shape = shapes_[i];
      const std::size_t side = dot(shape.vectorAreaMm2, mean) < most * shape.areaMm2 ? 1 : 0;
      areaMm2[side] += shape.areaMm2;
      addTimes(shape.areaMm2, shape.middleMm, middleMm[side]);
    }
    if (areaMm2[1] <= leastOfOtherSide * below.areaMm2) return false;
    Vector apart{};
    addTimes(1 / areaMm2[0], middleMm[0], apart);
    addTimes(-1 / areaMm2[1], middleMm[1], apart);
    return dot(apart, apart) > apartInEdges * apartInEdges * below.areaMm2;
  }

  // Treats the node as the thinnest that is followed, so that its clusters have one side each.
  void divide(Below& below) const {
    const double least = leastPart * edges_[below.object].usual;
    below.wantedMm = std::min(below.wantedMm, least);
    below.ofShapeMm = least;
    below.thinnessPerMm = 1 / least;
  }

  static double followed(double thicknessMm, double usualMm) {
    return std::clamp(thicknessMm, leastPart * usualMm, usualMm);
  }

  template <typename Visit>
  void forEachChild(std::uint32_t node, const Visit& visit) const {
    const std::uint32_t end = linkOf(surfels_.tree, node).end;
    for (std::uint32_t child = node + 1; child < end; child = linkOf(surfels_.tree, child).end)
      visit(child);
  }

  // Visits the root of an object's surfels and, if it has a lining, that of the lining.
  template <typename Visit>
  void forEachRoot(std::size_t object, const Visit& visit) const {
    const std::vector<std::uint32_t>& roots = surfels_.tree.rootOfObject;
    for (std::uint32_t root = roots[object]; root < roots[object + 1];
         root = linkOf(surfels_.tree, root).end)
      visit(root);
  }

  // Returns the node after all those below it.
  std::uint32_t sum(std::uint32_t node, std::uint32_t object) {
    const NodeLink link = linkOf(surfels_.tree, node);
    const Edges& edges = edges_[object];
    Below below;
    below.object = object;
    const auto include = [&](double area, double weight, double wanted, double ofShape,
                             double thinness) {
      below.areaMm2 += area;
      below.weight += weight;
      below.wantedMm += weight * wanted;
      below.ofShapeMm += weight * ofShape;
      below.thinnessPerMm += weight * thinness;
    };
    if (link.leaf) {
      below.firstSurfel = link.first;
      below.endSurfel = link.first + link.count;
      for (std::uint32_t i = link.first; i < link.first + link.count; ++i) {
        if (edges.areAsItsTriangles()) {
          const double edge = edgeOverTriangle * std::sqrt(shapes_[i].areaMm2);
          include(shapes_[i].areaMm2, 1, edge, edge, 0);
          continue;
        }
        const double area = shapes_[i].areaMm2;
        const double ofShape = followed(thicknessMm_[i], edges.usual);
        include(area, area, followed(thicknessMm_[i], std::min(edges.usual, edges.largest)),
                ofShape, 1 / std::max(thicknessMm_[i], leastPart * edges.usual));
      }
    } else {
      for (std::uint32_t child = node + 1; child < link.end;) {
        const std::uint32_t next = sum(child, object);
        const Below& part = below_[child];
        if (child == node + 1) below.firstSurfel = part.firstSurfel;
        below.endSurfel = part.endSurfel;
        include(part.areaMm2, part.weight, part.wantedMm, part.ofShapeMm, part.thinnessPerMm);
        child = next;
      }
    }
    if (below.weight > 0)
      for (double* mean : {&below.wantedMm, &below.ofShapeMm, &below.thinnessPerMm})
        *mean /= below.weight;
    below_[node] = below;
    return link.end;
  }

  Need needOf(std::uint32_t node) const {
    const Below& below = below_[node];
    const Edges& edges = edges_[below.object];
    const double edge = below.edgeMm();
    const auto need = [node](bool forShape, double excess) {
      return Need{forShape, static_cast<int>(std::floor(2 * std::log2(excess))), node};
    };
    if (edges.areAsItsTriangles()) return need(true, edge / below.ofShapeMm);
    if (edge <= below.ofShapeMm) return need(false, edge / edges.largest);
    const double thin = std::clamp(edge * below.thinnessPerMm, 1.0, 1 / leastPart);
    return need(true, edge / edges.usual * std::pow(thin, thinPower));
  }

  // Adds the trees of both sides one after the other, under a root of their own.
  void addBothSides(std::uint32_t root) {
    const std::uint32_t made = nodeCount();
    made_.tree.links.push_back(0);
    add(root, false);
    add(root, true);
    made_.tree.links[made] = Tree::setBit | nodeCount();
  }

  // Adds the node or, if it is opened, what is below it.
  void add(std::uint32_t node, bool isBack) {
    const std::uint32_t made = nodeCount();
    made_.tree.links.push_back(0);
    if (!opened_[node]) {
      made_.tree.links[made] = Tree::leafBit | Tree::setBit | count();
      const auto [first, end] = std::pair(below_[node].firstSurfel, below_[node].endSurfel);
      const auto thickness = thicknessMm_.begin();
      made_.clusters.push_back(
          {first, end, isBack, *std::min_element(thickness + first, thickness + end)});
      return;
    }
    forEachChild(node, [&](std::uint32_t child) { add(child, isBack); });
    made_.tree.links[made] = Tree::setBit | nodeCount();
  }

  const SurfelDivision& surfels_;
  std::vector<SurfelShape> shapes_;
  std::vector<double> thicknessMm_;  // under each surfel
  std::vector<Edges> edges_;         // of each object
  std::vector<Below> below_;         // of each node
  std::vector<bool> opened_;         // each node
  ClusterDivision made_;
};

}  // namespace

double usualClusterMm(double areaOfObjectMm2) {
  return std::sqrt(areaOfObjectMm2 / usualClusters);
}

ClusterDivision makeClusters(const core::RestSurface& surface, const SurfelDivision& surfels,
                             std::span<const ClusterOrder> orders, std::size_t maxClusters) {
  Divider divider(surface, surfels, orders);
  const std::size_t wanted = divider.open(std::numeric_limits<std::size_t>::max());
  if (wanted > maxClusters) divider.open(maxClusters);
  ClusterDivision clusters = divider.collect();
  clusters.wanted = wanted;
  return clusters;
}

}  // namespace opaline::surfels
