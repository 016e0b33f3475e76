#include "paper/atlas/pack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace opaline::atlas {
namespace {

Outline square(double edge) {
  return {
      {{0, 0}, {edge, 0}, {edge, edge}, {0, edge}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, edge * edge};
}

TEST(Pack, OneSquareFillsTheMap) {
  const Layout layout = pack({square(7)}, 512, 2);
  EXPECT_GT(layout.scale * 7, .98);
  EXPECT_LE(layout.scale * 7, 1);
}

TEST(Pack, FourSquaresFillTheMapButForTheGutter) {
  const Layout layout = pack(std::vector<Outline>(4, square(1)), 512, 8);
  const double edgeTexels = layout.scale * 512;
  EXPECT_LE(2 * edgeTexels + 8, 512);
  EXPECT_GT(2 * edgeTexels + 8, 500);
}

TEST(Pack, MoreChartsThanGuttersAllowFindRoom) {
  // With gutters of two texels a map of 64² has room for about 450 charts.
  for (const std::size_t count : {200U, 1000U, 30000U}) {
    const Layout layout = pack(std::vector<Outline>(count, square(1)), 64, 2);
    ASSERT_EQ(layout.placements.size(), count);
    EXPECT_GT(layout.scale, 0);
    // The centres of equal squares lie at least an edge apart in x or y.
    std::vector<Point2> centres;
    for (const Placement& p : layout.placements) {
      const double half = layout.scale / 2;
      centres.push_back(
          {half * (p.cosine - p.sine) + p.offset[0], half * (p.sine + p.cosine) + p.offset[1]});
    }
    std::sort(centres.begin(), centres.end());
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = i + 1; j < count && centres[j][0] - centres[i][0] < layout.scale; ++j) {
        ASSERT_GE(std::fabs(centres[j][1] - centres[i][1]), layout.scale * (1 - 1e-9));
      }
    }
  }
}

TEST(Pack, NothingNeedsNoRoom) {
  EXPECT_TRUE(pack({}, 512, 2).placements.empty());
}

}  // namespace
}  // namespace opaline::atlas
