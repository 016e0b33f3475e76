#include "paper/nearest_texel.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace opaline::paper {
namespace {

std::vector<std::uint32_t> bruteForce(const std::vector<std::uint32_t>& coverage,
                                      std::uint32_t size) {
  std::vector<std::uint32_t> nearest(coverage.size(), 0);
  for (std::uint32_t i = 0; i < coverage.size(); ++i) {
    std::int64_t best = std::numeric_limits<std::int64_t>::max();
    for (std::uint32_t j = 0; j < coverage.size(); ++j) {
      if (coverage[j] == 0) continue;
      const std::int64_t dx = std::int64_t{i % size} - j % size;
      const std::int64_t dy = std::int64_t{i / size} - j / size;
      if (dx * dx + dy * dy >= best) continue;
      best = dx * dx + dy * dy;
      nearest[i] = j;
    }
  }
  return nearest;
}

TEST(NearestTexel, AgreesWithBruteForce) {
  std::mt19937 random(5);
  for (const std::uint32_t size : {1U, 2U, 7U, 24U, 33U})
    for (const double density : {0.003, 0.05, 0.5, 0.97}) {
      std::bernoulli_distribution covered(density);
      std::vector<std::uint32_t> coverage(std::size_t{size} * size);
      for (std::uint32_t& value : coverage) value = covered(random) ? 2 : 0;
      ASSERT_EQ(nearestCoveredTexel(coverage, size), bruteForce(coverage, size))
          << size << ' ' << density;
    }
}

TEST(NearestTexel, LowerIndexOfTwoAtTheSameDistance) {
  std::vector<std::uint32_t> coverage(25, 0);
  coverage[2] = coverage[10] = coverage[14] = coverage[22] = 1;  // around the centre, 12
  EXPECT_EQ(nearestCoveredTexel(coverage, 5)[12], 2U);
}

TEST(NearestTexel, NothingCoveredGivesZeros) {
  EXPECT_EQ(nearestCoveredTexel(std::vector<std::uint32_t>(64, 0), 8),
            std::vector<std::uint32_t>(64, 0));
}

}  // namespace
}  // namespace opaline::paper
