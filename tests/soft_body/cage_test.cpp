// The cage of a body, and how it carries the motion of its nodes to the body.

#include "soft_body/cage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "renderer/shapes.h"
#include "soft_body/spread.h"
#include "soft_body/voxels.h"

namespace opaline {
namespace {

using namespace test;

soft_body::Cage cageOf(const Mesh& mesh, std::uint32_t cells, double held = 0.06,
                       std::size_t maxNodes = 1360) {
  return soft_body::makeCage(mesh.positionsMm, mesh.triangles, cells, held, maxNodes);
}

TEST(CageTest, ABoxIsFilled) {
  const soft_body::Cage cage = cageOf(box({1, 2, 3}, {2, 3, 1}), 6);
  EXPECT_EQ(cage.counts, (std::array<std::uint32_t, 3>{4, 6, 2}));
  EXPECT_EQ(cage.cells.size(), 4U * 6 * 2);
  EXPECT_EQ(cage.nodes.size(), 5U * 7 * 3);
  EXPECT_NEAR(cage.cellMm, 1, 0.001);
  EXPECT_NEAR(cage.originMm[1], -1, 0.002);
  EXPECT_NEAR(cage.heightCells, 6, 0.01);
}

TEST(CageTest, ABallIsSolidAndItsCornersOfTheBoxAreEmpty) {
  const soft_body::Voxels voxels =
      soft_body::makeVoxels(sphere({0, 0, 0}, 5).positionsMm, sphere({0, 0, 0}, 5).triangles, 10);
  const auto filled = std::count(voxels.filled.begin(), voxels.filled.end(), true);
  // Its volume is 524 cells. Its surface meets cubes at most √3 cells outside or inside it.
  EXPECT_GT(filled, 524);
  EXPECT_LT(filled, 4.0 / 3 * 3.1416 * std::pow(5 + std::sqrt(3.0) / 2, 3));
  EXPECT_TRUE(voxels.filled[voxels.index(5, 5, 5)]);
  EXPECT_FALSE(voxels.filled[voxels.index(0, 0, 0)]);
}

TEST(CageTest, AnOpenMeshIsAShell) {
  const Mesh mesh = sheet({0, 0, 0}, {5, 0, 0}, {0, 5, 0});
  const soft_body::Cage cage = cageOf(mesh, 10);
  EXPECT_EQ(cage.counts[2], 1U);
  EXPECT_EQ(cage.cells.size(), 100U);
}

TEST(CageTest, HasNoMoreNodesThanThereMayBe) {
  const Mesh mesh = box({0, 0, 0}, {5, 5, 5});
  EXPECT_EQ(cageOf(mesh, 16).nodes.size(), 11U * 11 * 11);
  EXPECT_EQ(cageOf(mesh, 16, 0, 8).nodes.size(), 8U);
}

TEST(CageTest, CellsOfAColourHaveNoNodeInCommon) {
  const soft_body::Cage cage = cageOf(sphere({0, 0, 0}, 5), 9);
  EXPECT_EQ(cage.firstOfColour.front(), 0U);
  EXPECT_EQ(cage.firstOfColour.back(), cage.cells.size());
  for (std::size_t colour = 0; colour < 8; ++colour) {
    std::set<std::uint32_t> nodes;
    for (std::uint32_t c = cage.firstOfColour[colour]; c < cage.firstOfColour[colour + 1]; ++c)
      nodes.insert(cage.cells[c].begin(), cage.cells[c].end());
    EXPECT_EQ(nodes.size(), 8 * (cage.firstOfColour[colour + 1] - cage.firstOfColour[colour]));
  }
}

TEST(CageTest, TheLowestPartIsHeld) {
  const Mesh mesh = box({0, 5, 0}, {2, 5, 2});
  for (const auto& [fraction, height] : {std::pair{0.0, 0U}, {0.06, 0U}, {0.25, 2U}}) {
    const soft_body::Cage cage = cageOf(mesh, 10, fraction);
    for (std::size_t n = 0; n < cage.nodes.size(); ++n)
      EXPECT_EQ(cage.held[n], cage.nodes[n][1] <= height);
  }
}

// A linear field at the nodes stays linear.
TEST(SpreadTest, CarriesOnAffineMaps) {
  const soft_body::Cage cage = cageOf(sphere({0, 0, 0}, 5), 10);
  const soft_body::Spread spread = soft_body::makeSpread(cage);
  const auto field = [](double x, double y, double z) {
    return 0.3 + 0.1 * x - 0.2 * y + 0.05 * z;
  };
  int carried = 0;
  std::size_t place = 0;
  for (std::uint32_t z = 0; z < spread.size[2]; ++z)
    for (std::uint32_t y = 0; y < spread.size[1]; ++y)
      for (std::uint32_t x = 0; x < spread.size[0]; ++x, ++place) {
        double sum = 0;
        double weights = 0;
        for (std::uint32_t i = spread.firstPart[place]; i < spread.firstPart[place + 1]; ++i) {
          const auto& node = cage.nodes[spread.parts[i].node];
          sum += static_cast<double>(spread.parts[i].weight) * field(node[0], node[1], node[2]);
          weights += static_cast<double>(spread.parts[i].weight);
        }
        if (spread.firstPart[place] == spread.firstPart[place + 1]) continue;
        ++carried;
        ASSERT_NEAR(weights, 1, 1e-5);
        ASSERT_NEAR(sum, field(x - 1.0, y - 1.0, z - 1.0), 0.02);
      }
  EXPECT_GT(carried, static_cast<int>(cage.nodes.size()));
}

}  // namespace
}  // namespace opaline
