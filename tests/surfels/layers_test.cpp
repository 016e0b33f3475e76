#include "surfels/layers.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "surfels/bodies.h"
#include "surfels/clusters.h"
#include "surfels/surfels.h"

namespace opaline::surfels {
namespace {

using namespace test;

/// Both bodies as one object.
Body joined(const Body& a, const Body& b) {
  Body body = together(a, b);
  body.objectOfTriangle.assign(body.triangles.size(), 0);
  body.objects = 1;
  return body;
}

Body moved(Body body, const Vec3& by) {
  for (Vec3& position : body.positions)
    for (std::size_t axis = 0; axis < 3; ++axis) position[axis] += by[axis];
  return body;
}

/// Every triangle gets vertices of its own.
Body torn(const Body& whole) {
  Body body = whole;
  body.positions.clear();
  for (Triangle& triangle : body.triangles) {
    for (std::uint32_t& vertex : triangle) {
      body.positions.push_back(whole.positions[vertex]);
      vertex = static_cast<std::uint32_t>(body.positions.size() - 1);
    }
  }
  return body;
}

/// A sheet of paper of 60 × 40 on a box of 200 × 100, with a gap between them.
Body paperOnBox(float gapMm) {
  return joined(box(200, 10, 100), moved(box(60, 0.2F, 40), {70, 10 + gapMm, 30}));
}

/// The layers of all triangles of the first and of the other part.
std::array<std::set<int>, 2> layersOf(const Body& body, std::size_t first, double closeMm) {
  const core::RestSurface surface = body.surface();
  const std::vector<Piece> pieces =
      subdivide(surface, body.spacing(closeMm / 2), 1'000'000).value();
  std::vector<TreeItem> items;
  for (std::uint32_t i = 0; i < pieces.size(); ++i)
    items.push_back({middleOfMm(surface, pieces[i]), i});
  const std::vector<std::uint8_t> layers = Layers(surface).ofItems(pieces, items, closeMm);
  std::array<std::set<int>, 2> found;
  for (std::size_t i = 0; i < layers.size(); ++i)
    found[pieces[i].triangle < first ? 0 : 1].insert(layers[i]);
  return found;
}

using Numbers = std::array<std::set<int>, 2>;

TEST(Layers, TellPartsThatLieUponEachOther) {
  EXPECT_EQ(layersOf(paperOnBox(0.1F), 12, 4), (Numbers{{{0}, {1}}}));
  EXPECT_EQ(layersOf(paperOnBox(20), 12, 4), (Numbers{{{0}, {0}}}));
}

TEST(Layers, GoByWhereVerticesLieNotByTheirNumber) {
  EXPECT_EQ(layersOf(torn(paperOnBox(0.1F)), 12, 4), (Numbers{{{0}, {1}}}));
  EXPECT_EQ(layersOf(torn(box(20, 20, 20)), 6, 4), (Numbers{{{0}, {0}}}));
}

TEST(Layers, LeaveTogetherWhatFacesEachOther) {
  // The lower plate has a top, the upper one a bottom only.
  Body lower = box(40, 0, 40);
  lower.triangles = {lower.triangles[2], lower.triangles[3]};
  Body upper = moved(box(40, 0, 40), {0, 0.5F, 0});
  upper.triangles = {upper.triangles[0], upper.triangles[1]};
  lower.objectOfTriangle = upper.objectOfTriangle = {0, 0};
  EXPECT_EQ(layersOf(joined(lower, upper), 2, 4), (Numbers{{{0}, {0}}}));
}

TEST(Layers, LeaveCrumbsTogether) {
  EXPECT_EQ(layersOf(joined(box(20, 20, 20), moved(box(1, 1, 1), {5, 20.1F, 5})), 12, 4),
            (Numbers{{{0}, {0}}}));
}

TEST(Layers, AreFewHoweverManyPartsThereAre) {
  Body heap = box(10, 10, 10);
  for (int i = 0; i < 5; ++i) heap = joined(heap, moved(heap, {0.1F, 0.1F, 0}));
  for (const std::set<int>& numbers : layersOf(heap, 12, 2))
    for (const int layer : numbers) EXPECT_LT(layer, Layers::mostLayers);
}

TEST(Layers, NoLeafAndNoClusterHoldsTwo) {
  const Body body = paperOnBox(0.1F);
  const core::RestSurface surface = body.surface();
  const SurfelDivision surfels = makeSurfels(surface, body.spacing(0.5), 65'536);
  const auto expectOne = [&](std::uint32_t first, std::uint32_t end, const std::string& where) {
    for (std::uint32_t i = first; i < end; ++i)
      ASSERT_EQ(surfels.pieces[i].triangle < 12, surfels.pieces[first].triangle < 12) << where;
  };
  ASSERT_EQ(surfels.piecesPerSurfel, 1U);
  for (std::uint32_t node = 0; node < surfels.tree.links.size(); ++node) {
    const NodeLink link = linkOf(surfels.tree, node);
    if (link.leaf) expectOne(link.first, link.first + link.count, "leaf");
  }
  const ClusterDivision clusters =
      makeClusters(surface, surfels, std::vector<ClusterOrder>{{100}}, 8192);
  for (const ClusterDivision::Cluster& cluster : clusters.clusters)
    expectOne(cluster.firstSurfel, cluster.endSurfel, "cluster");
}

}  // namespace
}  // namespace opaline::surfels
