#include "surfels/clusters.h"

#include <gtest/gtest.h>

#include <limits>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "surfels/bodies.h"
#include "surfels/surfels.h"
#include "surfels/tree.h"

namespace opaline::surfels {
namespace {

// However large.
ClusterDivision clustersOf(const core::RestSurface& surface, const SurfelDivision& surfels,
                           std::size_t budget) {
  const std::vector<ClusterOrder> orders(surfels.spacingOfObjectMm.size(),
                                         {std::numeric_limits<double>::infinity()});
  return makeClusters(surface, surfels, orders, budget);
}

using namespace test;

constexpr std::size_t unlimited = 1'000'000;

/// Follows the description in tree.h: depth first, with leaves in the order of the clusters.
class ClusterWalk {
 public:
  explicit ClusterWalk(const Tree& tree) : tree_(tree) {}

  std::uint32_t clusters() const { return next_; }

  /// Returns the node after the subtree.
  std::uint32_t enter(std::uint32_t node, std::uint32_t end) {
    const std::uint32_t link = tree_.links[node];
    EXPECT_NE(link & Tree::setBit, 0U);
    if ((link & Tree::leafBit) != 0) {
      EXPECT_EQ(link & ~(Tree::leafBit | Tree::setBit), next_) << "one cluster a leaf, in order";
      ++next_;
      return node + 1;
    }
    const std::uint32_t after = link & (Tree::setBit - 1);
    EXPECT_GT(after, node + 1);
    EXPECT_LE(after, end);
    std::uint32_t children = 0;
    for (std::uint32_t child = node + 1; child < after && !testing::Test::HasFailure(); ++children)
      child = enter(child, after);
    EXPECT_GE(children, 2U);
    EXPECT_LE(children, 4U);
    return after;
  }

 private:
  const Tree& tree_;
  std::uint32_t next_ = 0;
};

void expectTree(const ClusterDivision& made) {
  ClusterWalk walk(made.tree);
  const std::vector<std::uint32_t>& roots = made.tree.rootOfObject;
  ASSERT_EQ(roots.front(), 0U);
  ASSERT_EQ(roots.back(), made.tree.links.size());
  for (std::size_t object = 0; object + 1 < roots.size(); ++object) {
    ASSERT_EQ(walk.clusters(), made.firstOfObject[object]);
    if (roots[object] < roots[object + 1]) {
      ASSERT_EQ(walk.enter(roots[object], roots[object + 1]), roots[object + 1]);
    }
  }
  ASSERT_EQ(walk.clusters(), made.count());
}

/// Expects every surfel in exactly one cluster; a cluster's surfels are consecutive and of one
/// object.
void expectPartition(const SurfelDivision& surfels, const ClusterDivision& made) {
  ASSERT_EQ(made.firstOfObject.size(), surfels.firstOfObject.size());
  ASSERT_EQ(made.clusters.size(), std::size_t{made.count()});
  ASSERT_EQ(made.firstOfObject.front(), 0U);
  std::uint32_t next = 0;
  for (std::size_t object = 0; object + 1 < made.firstOfObject.size(); ++object) {
    ASSERT_EQ(next, surfels.firstOfObject[object]);
    for (std::uint32_t i = made.firstOfObject[object]; i < made.firstOfObject[object + 1]; ++i) {
      ASSERT_EQ(made.clusters[i].firstSurfel, next);
      next = made.clusters[i].endSurfel;
      ASSERT_LT(made.clusters[i].firstSurfel, next);
      ASSERT_FALSE(made.clusters[i].isBack);
    }
  }
  ASSERT_EQ(next, surfels.count());
}

std::size_t objectsWithSurfels(const SurfelDivision& surfels) {
  std::size_t count = 0;
  for (std::size_t i = 0; i + 1 < surfels.firstOfObject.size(); ++i)
    if (surfels.firstOfObject[i] < surfels.firstOfObject[i + 1]) ++count;
  return count;
}

TEST(Clusters, HoldEverySurfelOnceWithinTheBudget) {
  for (const Body& body : allBodies())
    for (const std::size_t maxSurfels : {200U, 20'000U}) {
      const SurfelDivision surfels = makeSurfels(body.surface(), body.spacing(0.02), maxSurfels);
      const std::size_t least = objectsWithSurfels(surfels);
      for (const std::size_t budget :
           {std::size_t{1}, std::size_t{64}, std::size_t{500}, unlimited}) {
        const ClusterDivision made = clustersOf(body.surface(), surfels, budget);
        EXPECT_LE(made.count(), std::max(budget, least)) << body.name;
        EXPECT_GE(made.count(), least) << body.name;
        expectPartition(surfels, made);
        expectTree(made);
        if (HasFailure()) FAIL() << body.name << ", " << maxSurfels << ", " << budget;
      }
    }
}

TEST(Clusters, AreAlwaysTheSame) {
  const Body body = bodyOf(awkward::torus());
  const SurfelDivision surfels = makeSurfels(body.surface(), body.spacing(0.05), 100'000);
  const ClusterDivision once = clustersOf(body.surface(), surfels, 1000);
  const ClusterDivision again = clustersOf(body.surface(), surfels, 1000);
  EXPECT_TRUE(once.clusters == again.clusters);
  EXPECT_EQ(once.tree.links, again.tree.links);
}

/// A cluster as one flat patch.
struct Patch {
  double areaMm2 = 0;
  Point middle{};
  Point normal{};  // unit where it is flat

  double edgeMm() const { return std::sqrt(areaMm2); }
};

std::vector<Patch> patchesOf(const Body& body, const SurfelDivision& surfels,
                             const ClusterDivision& made) {
  std::vector<Patch> patches(made.count());
  for (std::uint32_t i = 0; i < made.count(); ++i) {
    Patch& patch = patches[i];
    for (std::size_t k = std::size_t{made.clusters[i].firstSurfel} * surfels.piecesPerSurfel;
         k < std::size_t{made.clusters[i].endSurfel} * surfels.piecesPerSurfel; ++k) {
      const Piece& piece = surfels.pieces[k];
      const Point cross = crossOf(body.surface(), piece.triangle);
      const std::array<Point, 3> corners = placesOf(body, piece);
      const double area =
          static_cast<double>(piece.fraction) * std::hypot(cross[0], cross[1], cross[2]) / 2;
      patch.areaMm2 += area;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        patch.normal[axis] += static_cast<double>(piece.fraction) * cross[axis] / 2;
        for (const Point& corner : corners) patch.middle[axis] += area * corner[axis] / 3;
      }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      patch.middle[axis] /= patch.areaMm2;
      patch.normal[axis] /= patch.areaMm2;
    }
  }
  return patches;
}

// A node has up to four children with equal numbers of surfels. What is too large for a cluster is
// split into clusters of at least a quarter, up to differences between surfels.
constexpr double smallestPart = 0.2;

TEST(Clusters, OfAThickBodyAreAsLargeAsUsual) {
  const Body body = bodyOf(awkward::sphere());
  const SurfelDivision surfels = makeSurfels(body.surface(), body.spacing(0.02), unlimited);
  const ClusterDivision made = clustersOf(body.surface(), surfels, unlimited);
  double area = 0;
  for (const Patch& patch : patchesOf(body, surfels, made)) area += patch.areaMm2;
  const double usual = usualClusterMm(area);
  for (const Patch& patch : patchesOf(body, surfels, made))
    ASSERT_LE(patch.edgeMm(), usual * (1 + 1e-6));
  // None is larger than usual, and none much smaller than a quarter.
  const double fewest = area / (usual * usual);
  EXPECT_GE(made.count(), fewest * (1 - 1e-6));
  EXPECT_LE(made.count(), fewest / smallestPart);
}

/// Whether a part is at the narrow sides, which are thick, of a plate across y from 0 to `edge`.
bool isAtRim(const Patch& patch, double edge, double within) {
  const auto [low, high] = std::minmax(patch.middle[0], patch.middle[2]);
  return std::abs(patch.normal[1]) < 0.99 || low < within || high > edge - within;
}

// Between the usual size and a quarter of it, clusters are as large as the slab is thick.
TEST(Clusters, OfASlabAreAsLargeAsItIsThick) {
  constexpr double edge = 8;
  for (const double thick : {0.18, 0.12, 0.07}) {
    const Body body =
        box(static_cast<float>(edge), static_cast<float>(thick), static_cast<float>(edge));
    const double area = 2 * edge * edge + 4 * edge * thick;
    ASSERT_GT(usualClusterMm(area), thick);
    ASSERT_LT(usualClusterMm(area) / 4, thick);
    const SurfelDivision surfels = makeSurfels(body.surface(), body.spacing(0.02), unlimited);
    const ClusterDivision made = clustersOf(body.surface(), surfels, unlimited);
    int counted = 0;
    for (const Patch& patch : patchesOf(body, surfels, made)) {
      if (isAtRim(patch, edge, 2 * thick)) continue;
      ++counted;
      ASSERT_LE(patch.edgeMm(), thick * (1 + 1e-4));
      ASSERT_GE(patch.areaMm2, smallestPart * thick * thick);
    }
    EXPECT_GT(counted, 1000);
  }
}

// Below a quarter of the usual size, thickness no longer matters.
TEST(Clusters, OfALeafAreAQuarterOfUsual) {
  constexpr double edge = 8;
  const Body body = box(static_cast<float>(edge), 0.001F, static_cast<float>(edge));
  const double least = usualClusterMm(2 * edge * edge + 4 * edge * 0.001) / 4;
  const SurfelDivision surfels = makeSurfels(body.surface(), body.spacing(0.01), 4 * unlimited);
  for (const Patch& patch :
       patchesOf(body, surfels, clustersOf(body.surface(), surfels, unlimited))) {
    if (isAtRim(patch, edge, 0.2)) continue;
    ASSERT_LE(patch.edgeMm(), least * (1 + 1e-4));
    ASSERT_GE(patch.areaMm2, smallestPart * least * least);
  }
}

// Holds even where clusters consist of several leaves: a cluster with both sides would have its
// place inside.
TEST(Clusters, NoneHoldsBothSidesOfASlab) {
  constexpr double edge = 8;
  for (const double thick : {0.05, 0.3, 3.0})
    for (const std::size_t maxSurfels : {33'000U, 100'000U}) {
      const Body body =
          box(static_cast<float>(edge), static_cast<float>(thick), static_cast<float>(edge));
      const SurfelDivision surfels = makeSurfels(body.surface(), body.spacing(0.02), maxSurfels);
      const ClusterDivision made = clustersOf(body.surface(), surfels, 4000);
      int inside = 0;
      for (const Patch& patch : patchesOf(body, surfels, made)) {
        const auto [low, high] = std::minmax(patch.middle[0], patch.middle[2]);
        if (low > 1 && high < edge - 1 && std::abs(patch.normal[1]) < 0.999) ++inside;
      }
      EXPECT_EQ(inside, 0) << thick << " mm, " << maxSurfels << " surfels at most";
    }
}

// The wall is thicker than a cluster and runs in all directions; the tree divides along three.
TEST(Clusters, NoneHoldsBothSidesOfAHollowSphere) {
  const Body body = hollowSphere(0.85F);
  const SurfelDivision surfels = makeSurfels(body.surface(), body.spacing(0.01), unlimited);
  const ClusterDivision made = clustersOf(body.surface(), surfels, unlimited);
  const std::vector<Patch> patches = patchesOf(body, surfels, made);
  double area = 0;
  for (const Patch& patch : patches) area += patch.areaMm2;
  const double usual = usualClusterMm(area);
  int ofBothSides = 0;
  for (const Patch& patch : patches)
    if (patch.edgeMm() > usual / 4 &&
        std::hypot(patch.normal[0], patch.normal[1], patch.normal[2]) < 0.9)
      ++ofBothSides;
  EXPECT_EQ(ofBothSides, 0) << "of " << made.count();
}

// From the usual size at the thick end to the thickness at the thin end.
TEST(Clusters, OfAWedgeFollowItsThickness) {
  constexpr double length = 8;
  const Body body = wedge(static_cast<float>(length), 0.06F, 0.46F, 8);
  const SurfelDivision surfels = makeSurfels(body.surface(), body.spacing(0.02), unlimited);
  const ClusterDivision made = clustersOf(body.surface(), surfels, unlimited);
  const std::vector<Patch> patches = patchesOf(body, surfels, made);
  double area = 0;
  for (const Patch& patch : patches) area += patch.areaMm2;
  const double usual = usualClusterMm(area);
  for (const Patch& patch : patches) {
    if (patch.normal[1] > -0.999) continue;  // of the bottom alone
    const double thick = std::clamp(0.06 + 0.05 * patch.middle[0], usual / 4, usual);
    // A cluster is up to `usual` long, over which the thickness changes by a tenth of that.
    ASSERT_LE(patch.edgeMm(), thick * 1.05) << patch.middle[0];
    ASSERT_GE(patch.areaMm2, smallestPart * thick * thick) << patch.middle[0];
  }
}

// An opened node makes at most four clusters of one.
TEST(Clusters, UseTheirBudget) {
  const Body body = bodyOf(awkward::torus());
  const SurfelDivision surfels = makeSurfels(body.surface(), body.spacing(0.02), unlimited);
  const std::size_t wanted = clustersOf(body.surface(), surfels, unlimited).count();
  ASSERT_GT(wanted, 2000U);
  for (const std::size_t budget : {std::size_t{64}, std::size_t{500}, std::size_t{1500}}) {
    const ClusterDivision made = clustersOf(body.surface(), surfels, budget);
    EXPECT_GT(made.count() + 3, budget);
    EXPECT_EQ(made.wanted, wanted);
  }
  EXPECT_EQ(clustersOf(body.surface(), surfels, wanted).count(), wanted);
}

// Both ends of a wedge, equally large, are too coarse; clusters with both sides would be worse.
TEST(Clusters, BeyondTheBudgetAreFinerWhereTheBodyIsThin) {
  constexpr double length = 8;
  const Body body = wedge(static_cast<float>(length), 0.06F, 0.46F, 8);
  const SurfelDivision surfels = makeSurfels(body.surface(), body.spacing(0.02), 100'000);
  int thin = 0;
  int thick = 0;
  for (const Patch& patch : patchesOf(body, surfels, clustersOf(body.surface(), surfels, 512))) {
    if (patch.middle[0] < length / 4) ++thin;
    if (patch.middle[0] > length * 3 / 4) ++thick;
  }
  EXPECT_GT(thick, 0);
  EXPECT_GT(thin, 2 * thick);
}

// Holds for any density of another object's medium and for any size of that object.
TEST(Clusters, WhatAMediumAsksForTakesNoneFromAnotherShape) {
  Body floor = box(80, 8, 80);
  for (Vec3& p : floor.positions) p[1] -= 20;
  const Body body = together(bodyOf(awkward::sphere()), floor);
  const SurfelDivision surfels = makeSurfels(body.surface(), body.spacing(0.02), 200'000);
  const ClusterDivision ofShape = clustersOf(body.surface(), surfels, unlimited);
  const std::vector<ClusterOrder> orders{{std::numeric_limits<double>::infinity()}, {0.5}};
  const ClusterDivision made =
      makeClusters(body.surface(), surfels, orders, ofShape.count() + std::size_t{500});
  EXPECT_EQ(made.firstOfObject[1], ofShape.firstOfObject[1]);
  EXPECT_GT(made.count(), ofShape.count() + 400U);
  EXPECT_GT(made.coarseness(), 1.5);
}

TEST(Clusters, OfABackAreThoseOfItsFront) {
  const Body body = together(bodyOf(awkward::sphere()), box(80, 8, 80));
  const SurfelDivision surfels = makeSurfels(body.surface(), body.spacing(0.02), 20'000);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<ClusterOrder> orders{{infinity}, {infinity, true}};
  for (const std::size_t budget : {std::size_t{300}, unlimited}) {
    const ClusterDivision made = makeClusters(body.surface(), surfels, orders, budget);
    expectTree(made);
    EXPECT_LE(made.count(), budget);
    const std::uint32_t backs = (made.firstOfObject[2] - made.firstOfObject[1]) / 2;
    ASSERT_GT(backs, 20U);
    for (std::uint32_t i = made.firstOfObject[1]; i < made.firstOfObject[1] + backs; ++i) {
      const ClusterDivision::Cluster& front = made.clusters[i];
      EXPECT_TRUE(
          made.clusters[i + backs] ==
          (ClusterDivision::Cluster{front.firstSurfel, front.endSurfel, true, front.thicknessMm}));
      EXPECT_FALSE(front.isBack);
    }
  }
}

TEST(Clusters, KnowHowThickTheBodyIs) {
  const Body body = box(80, 8, 80);
  const SurfelDivision surfels = makeSurfels(body.surface(), body.spacing(0.02), 20'000);
  const ClusterDivision made = clustersOf(body.surface(), surfels, unlimited);
  std::size_t across = 0;
  for (const ClusterDivision::Cluster& cluster : made.clusters) {
    const bool isThin = std::abs(cluster.thicknessMm - 8) < 1e-3;
    EXPECT_TRUE(isThin || std::abs(cluster.thicknessMm - 80) < 1e-3) << cluster.thicknessMm;
    across += isThin ? 1 : 0;
  }
  EXPECT_GT(across, made.clusters.size() / 2);
}

}  // namespace
}  // namespace opaline::surfels
