#include "surfels/linings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <vector>

#include "surfels/bodies.h"
#include "surfels/clusters.h"
#include "surfels/surfels.h"
#include "surfels/winding.h"

namespace opaline::surfels {
namespace {

using namespace test;

/// A box between two corners, `cells`² squares a side.
Body boxBetween(const Vec3& low, const Vec3& high, int cells) {
  Body body{"box", {}, {}, {}, 1};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool top : {false, true}) {
      const std::size_t u = (axis + (top ? 1 : 2)) % 3;
      const std::size_t v = (axis + (top ? 2 : 1)) % 3;
      const auto first = static_cast<std::uint32_t>(body.positions.size());
      for (int i = 0; i <= cells; ++i)
        for (int k = 0; k <= cells; ++k) {
          Vec3 place{};
          place[axis] = top ? high[axis] : low[axis];
          place[u] = std::lerp(low[u], high[u], static_cast<float>(i) / static_cast<float>(cells));
          place[v] = std::lerp(low[v], high[v], static_cast<float>(k) / static_cast<float>(cells));
          body.positions.push_back(place);
        }
      const auto row = static_cast<std::uint32_t>(cells + 1);
      for (std::uint32_t i = 0; i + 1 < row; ++i)
        for (std::uint32_t k = 0; k + 1 < row; ++k) {
          const std::uint32_t at = first + i * row + k;
          body.triangles.push_back({at, at + row, at + row + 1});
          body.triangles.push_back({at, at + row + 1, at + 1});
        }
    }
  body.objectOfTriangle.assign(body.triangles.size(), 0);
  return body;
}

/// One substance per object.
Linings liningsOf(const Body& body, const std::vector<Substance>& substances) {
  std::vector<Substance> ofTriangles;
  for (const std::uint32_t object : body.objectOfTriangle)
    ofTriangles.push_back(substances[object]);
  return Linings(body.surface(), ofTriangles);
}

const std::vector<Substance> bodyAndSolid{Substance::Medium, Substance::Solid};

struct Sums {
  double areaMm2 = 0;
  Vector vectorAreaMm2{};
};

Sums sumsOf(const core::RestSurface& surface, const std::vector<Piece>& pieces) {
  Sums sums;
  for (const Piece& piece : pieces) {
    const auto fraction = static_cast<double>(piece.fraction);
    sums.areaMm2 += fraction * areaMm2(surface, piece.triangle);
    addTimes(fraction / 2, crossOf(surface, piece.triangle), sums.vectorAreaMm2);
  }
  return sums;
}

TEST(WindingNumber, Is1InsideAnd0Outside) {
  const Body body = boxBetween({-3, -2, -1}, {3, 2, 1}, 24);
  std::vector<std::uint32_t> all(body.triangles.size());
  std::iota(all.begin(), all.end(), 0U);
  const WindingNumber winding(body.surface(), all);
  for (double x = -3.9; x < 4; x += 0.6)
    for (double y = -2.95; y < 3; y += 0.5)
      for (double z = -1.95; z < 2; z += 0.3) {
        const bool inside = std::abs(x) < 3 && std::abs(y) < 2 && std::abs(z) < 1;
        EXPECT_NEAR(winding.at({x, y, z}), inside ? 1 : 0, 0.02) << x << " " << y << " " << z;
        EXPECT_EQ(winding.isInside({x, y, z}), inside);
      }
}

TEST(WindingNumber, OfNothingIsNowhereInside) {
  const Body body = boxBetween({-1, -1, -1}, {1, 1, 1}, 2);
  const WindingNumber winding(body.surface(), {});
  EXPECT_EQ(winding.at({0, 0, 0}), 0);
  EXPECT_FALSE(winding.isInside({0, 0, 0}));
}

TEST(Linings, OfSomethingWithinAreAllOfItTurnedRound) {
  const Body body =
      together(boxBetween({-5, -5, -5}, {5, 5, 5}, 8), boxBetween({-1, -1, -3}, {1, 2, 3}, 4));
  const Linings linings = liningsOf(body, bodyAndSolid);
  ASSERT_TRUE(linings.any());
  const core::RestSurface lined = linings.lined(body.surface());
  EXPECT_NEAR(sumsOf(lined, linings.pieces()).areaMm2, 2 * (2 * 3 + 2 * 6 + 3 * 6), 1e-3);
  for (const Piece& piece : linings.pieces()) {
    EXPECT_GE(piece.triangle, linings.firstTriangle());
    EXPECT_EQ(lined.objectOfTriangle[piece.triangle], 0U);
    // Into the solid, whose middle is (0, .5, 0), and so do the piece's corners go round.
    const Vec3 at = middleOfMm(lined, piece);
    EXPECT_LT(dot(crossOf(lined, piece.triangle), {at[0], at[1] - 0.5, at[2]}), 0);
    const auto& [a, b, c] = piece.corners;
    EXPECT_GT((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]), 0);
    const std::uint32_t its = linings.triangleOfSolid()[piece.triangle - linings.firstTriangle()];
    const Vector solids = crossOf(body.surface(), its);
    const Vector turned = crossOf(lined, piece.triangle);
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_EQ(turned[axis], -solids[axis]);
  }
}

// A wick: the part of its sides that is in the wax, and its lower end.
TEST(Linings, OfWhatReachesInAreThePartInside) {
  const Body body =
      together(boxBetween({-5, 0, -5}, {5, 10, 5}, 8), boxBetween({-1, 4, -1}, {1, 13, 1}, 1));
  const Linings linings = liningsOf(body, bodyAndSolid);
  const core::RestSurface lined = linings.lined(body.surface());
  EXPECT_NEAR(sumsOf(lined, linings.pieces()).areaMm2, 4 * 2 * 6 + 4, 0.5);
}

// A body standing on something does not touch it; a body sunk into it does. The table's surface
// then closes the part of the body above it.
TEST(Linings, AreWhereABodyIsSunkIntoATable) {
  const Body table = boxBetween({-50, -2, -50}, {50, 0, 50}, 1);
  const Body standing = together(boxBetween({-5, 0, -5}, {5, 10, 5}, 8), table);
  EXPECT_FALSE(liningsOf(standing, bodyAndSolid).any());
  const Body sunk = together(boxBetween({-5, -0.5F, -5}, {5, 9.5F, 5}, 40), table);
  const Linings linings = liningsOf(sunk, bodyAndSolid);
  const core::RestSurface lined = linings.lined(sunk.surface());
  EXPECT_NEAR(sumsOf(lined, linings.pieces()).areaMm2, 100, 1);
  const SurfelDivision surfels =
      makeSurfels(lined, std::vector<double>{0.2, 1e9}, 1'000'000, linings);
  std::vector<Piece> ofBody(surfels.pieces.begin(),
                            surfels.pieces.begin() + surfels.firstOfObject[1]);
  const Sums closed = sumsOf(lined, ofBody);
  EXPECT_NEAR(closed.areaMm2, 100 + 100 + 4 * 10 * 9.5, 3);
  EXPECT_LT(std::sqrt(dot(closed.vectorAreaMm2, closed.vectorAreaMm2)), 1);
}

// The body would have no surface left.
TEST(Linings, LeaveABodyWithinASolidAsItIs) {
  const Body body =
      together(boxBetween({-1, -1, -1}, {1, 1, 1}, 4), boxBetween({-5, -5, -5}, {5, 5, 5}, 8));
  const Linings linings = liningsOf(body, bodyAndSolid);
  EXPECT_FALSE(linings.any());
  EXPECT_EQ(makeSurfels(body.surface(), body.spacing(0.5), 10'000, linings).count(),
            makeSurfels(body.surface(), body.spacing(0.5), 10'000).count());
}

TEST(Linings, OfSheetsAreNoneAndSayWhich) {
  const Body body =
      together(boxBetween({-5, -5, -5}, {5, 5, 5}, 8), boxBetween({-1, -1, -3}, {1, 2, 3}, 4));
  const Linings linings = liningsOf(body, {Substance::Medium, Substance::Sheet});
  EXPECT_FALSE(linings.any());
  EXPECT_EQ(linings.sheetsInside(), std::vector<std::uint32_t>{1});
  EXPECT_TRUE(liningsOf(body, {Substance::Other, Substance::Sheet}).sheetsInside().empty());
}

// There is no medium between two solids that intersect.
TEST(Linings, AreNotWhereOneSolidLiesInAnother) {
  const Body inner =
      together(boxBetween({-1, -1, -1}, {1, 1, 1}, 4), boxBetween({-2, -2, -2}, {2, 2, 2}, 4));
  const Body body = together(boxBetween({-5, -5, -5}, {5, 5, 5}, 8), inner);
  const Linings linings = liningsOf(body, {Substance::Medium, Substance::Solid, Substance::Solid});
  const core::RestSurface lined = linings.lined(body.surface());
  EXPECT_NEAR(sumsOf(lined, linings.pieces()).areaMm2, 6 * 16, 1e-3);
}

// Whatever the surfaces, valid surfels and clusters are made, and no more than wanted.
TEST(Linings, OfAwkwardBodiesAreSound) {
  for (const Body& awkward : allBodies())
    for (const bool within : {false, true}) {
      SCOPED_TRACE(awkward.name);
      const Body body = together(boxBetween({-1.5F, -1.5F, -1.5F}, {0.3F, 1.5F, 1.5F}, 6), awkward);
      std::vector<Substance> substances(body.objects,
                                        within ? Substance::Solid : Substance::Medium);
      substances[0] = within ? Substance::Medium : Substance::Solid;
      const Linings linings = liningsOf(body, substances);
      const core::RestSurface lined = linings.lined(body.surface());
      const SurfelDivision surfels = makeSurfels(lined, body.spacing(0.3), 2000, linings);
      EXPECT_LE(surfels.count(), 2000U);
      const std::vector<ClusterOrder> orders(body.objects, {100});
      const ClusterDivision clusters = makeClusters(lined, surfels, orders, 400 + body.objects);
      std::size_t held = 0;
      for (const ClusterDivision::Cluster& cluster : clusters.clusters)
        held += cluster.endSurfel - cluster.firstSurfel;
      EXPECT_EQ(held, surfels.count());
    }
}

// Triangles beyond the number of allowed extra pieces are all kept.
TEST(Linings, OfDenseSolidsHaveAPieceForEachTriangle) {
  const Body body =
      together(boxBetween({-5, -5, -5}, {5, 5, 5}, 4), boxBetween({-1, -1, -1}, {1, 1, 1}, 110));
  const Linings linings = liningsOf(body, bodyAndSolid);
  EXPECT_EQ(linings.pieces().size(), body.triangles.size() - 12 * 16);
}

// Clusters consist of one or the other, whatever their number, and follow the gap between.
TEST(Linings, HaveClustersOfTheirOwn) {
  const Body body = together(boxBetween({-5, -5, -5}, {5, 5, 5}, 8),
                             boxBetween({-1, -1, -4.8F}, {1, 2, 4.8F}, 4));
  const Linings linings = liningsOf(body, bodyAndSolid);
  const core::RestSurface lined = linings.lined(body.surface());
  for (const std::size_t maxSurfels : {std::size_t{300}, std::size_t{20'000}})
    for (const std::size_t maxClusters : {std::size_t{3}, std::size_t{64}, std::size_t{5000}}) {
      const SurfelDivision surfels =
          makeSurfels(lined, std::vector<double>{0.3, 1}, maxSurfels, linings);
      EXPECT_LE(surfels.count(), maxSurfels);
      EXPECT_LT(surfels.firstLiningOfObject[0], surfels.firstOfObject[1]);
      EXPECT_EQ(surfels.firstLiningOfObject[1], surfels.firstOfObject[2]);
      const std::vector<ClusterOrder> orders(2, {100});
      const ClusterDivision clusters = makeClusters(lined, surfels, orders, maxClusters);
      EXPECT_LE(clusters.count(), maxClusters);
      std::uint32_t next = 0;
      for (const ClusterDivision::Cluster& cluster : clusters.clusters) {
        EXPECT_EQ(cluster.firstSurfel, next);
        next = cluster.endSurfel;
        EXPECT_EQ(cluster.firstSurfel < surfels.firstLiningOfObject[0],
                  cluster.endSurfel <= surfels.firstLiningOfObject[0]);
      }
      EXPECT_EQ(next, surfels.count());
    }
}

}  // namespace
}  // namespace opaline::surfels
