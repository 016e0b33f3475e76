#include "scene/mesh/ears.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace opaline::scene {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

constexpr std::size_t endless = ~std::size_t{0};

bool contains(const Double2& a, const Double2& b, const Double2& c, const Double2& p) {
  if (p == a || p == b || p == c) return false;
  return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

/// Directly by the definition: every corner is tested against every other.
bool clipByDefinition(const std::vector<Double2>& p, Triangles& triangles) {
  std::vector<std::uint32_t> ring(p.size());
  std::iota(ring.begin(), ring.end(), 0U);
  std::size_t at = 0;
  for (std::size_t failures = 0; ring.size() > 3;) {
    const std::size_t n = ring.size();
    at %= n;
    const std::uint32_t a = ring[(at + n - 1) % n];
    const std::uint32_t b = ring[at];
    const std::uint32_t c = ring[(at + 1) % n];
    const bool isEar =
        turn(p[a], p[b], p[c]) > 0 && std::none_of(ring.begin(), ring.end(), [&](auto other) {
          return other != a && other != b && other != c && contains(p[a], p[b], p[c], p[other]);
        });
    if (isEar) {
      triangles.push_back({a, b, c});
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at));
      failures = 0;
    } else if (++failures > n) {
      return false;
    } else {
      ++at;
    }
  }
  triangles.push_back({ring[0], ring[1], ring[2]});
  return true;
}

std::vector<Double2> anyPolygon(std::minstd_rand& random) {
  const auto below = [&](std::uint32_t limit) {
    return static_cast<std::uint32_t>((random() >> 8U) % limit);
  };
  std::vector<Double2> polygon(4 + below(120));
  const bool isStar = below(2) == 0;
  const std::uint32_t lattice = 3 + below(20);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const double angle =
        6.283185307179586 * static_cast<double>(i) / static_cast<double>(polygon.size());
    const double radius = 1 + below(100);
    polygon[i] =
        isStar ? Double2{radius * std::cos(angle), radius * std::sin(angle)}
               : Double2{static_cast<double>(below(lattice)), static_cast<double>(below(lattice))};
  }
  return polygon;
}

TEST(Ears, AreThoseOfTheDefinition) {
  std::minstd_rand random(1);
  Ears ears;
  std::size_t whole = 0;
  for (int round = 0; round < 2000; ++round) {
    const std::vector<Double2> polygon = anyPolygon(random);
    Triangles expected;
    Triangles found;
    std::size_t steps = 0;
    const bool isWhole = clipByDefinition(polygon, expected);
    ASSERT_EQ(ears.clip(polygon, endless, steps, [&](const auto& ear) { found.push_back(ear); }),
              isWhole);
    ASSERT_EQ(found, expected) << polygon.size();
    whole += isWhole ? 1 : 0;
  }
  EXPECT_GT(whole, 500U);
  EXPECT_LT(whole, 1900U);
}

std::size_t stepsOfComb(std::uint32_t teeth) {
  std::vector<Double2> comb{{0, 0}, {static_cast<double>(teeth), 0}};
  for (std::uint32_t i = teeth; i-- > 0;)
    comb.push_back({static_cast<double>(i), i % 2 == 0 ? 1.0 : 100.0});
  std::size_t steps = 0;
  std::size_t triangles = 0;
  Ears ears;
  EXPECT_TRUE(ears.clip(comb, endless, steps, [&](const auto&) { ++triangles; }));
  EXPECT_EQ(triangles, comb.size() - 2);
  return steps;
}

TEST(Ears, OfACombTakeHardlyMoreThanLinearWork) {
  EXPECT_LT(stepsOfComb(1U << 16U), 20 * stepsOfComb(1U << 12U));
}

TEST(Ears, EndWithTheWorkThatIsAllowed) {
  const std::vector<Double2> arrow{{0, 0}, {4, 0}, {1, 1}, {0, 4}};
  std::size_t steps = 0;
  EXPECT_FALSE(Ears().clip(arrow, 0, steps, [](const auto&) {}));
}

}  // namespace
}  // namespace opaline::scene
