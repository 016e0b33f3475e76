#include "paper/atlas/texel_row.h"

#include <gtest/gtest.h>

#include <random>

namespace opaline::atlas {
namespace {

bool isInside(const std::array<Point2, 3>& p, double x, double y) {
  int left = 0;
  int right = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2& a = p[i];
    const Point2& b = p[(i + 1) % 3];
    const double side = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    (side > 0 ? left : right) += 1;
  }
  return left == 0 || right == 0;
}

TEST(TexelRow, HoldsTheTexelsWhoseCentresLieInside) {
  constexpr int first = -3;
  constexpr int end = 20;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-8, 24);
  for (int round = 0; round < 2000; ++round) {
    std::array<Point2, 3> corners{};
    for (Point2& corner : corners) corner = {place(random), place(random)};
    for (int y = -10; y < 26; ++y) {
      const auto [from, to] = texelsInRow(corners, y, first, end);
      ASSERT_GE(from, first);
      ASSERT_LE(to, end);
      for (int x = first; x < end; ++x)
        ASSERT_EQ(from <= x && x < to, isInside(corners, x + .5, y + .5)) << x << ' ' << y;
    }
  }
}

TEST(TexelRow, IsEmptyBesideATriangleFarAway) {
  const std::array<Point2, 3> corners{{{1e12, -1e12}, {3e12, 1e12}, {2e12, 2e12}}};
  const auto [from, to] = texelsInRow(corners, 0, 0, 512);
  EXPECT_GE(from, to);
}

}  // namespace
}  // namespace opaline::atlas
