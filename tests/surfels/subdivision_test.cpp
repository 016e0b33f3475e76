#include "surfels/subdivision.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "surfels/bodies.h"

namespace opaline::surfels {
namespace {

using namespace test;

constexpr std::size_t plenty = 200'000;

// Moments of the barycentric coordinates v and w over a triangle.
struct Moments {
  double area = 0;
  double v = 0;
  double w = 0;
  double vv = 0;
  double vw = 0;
  double ww = 0;
};

// ∫ over a triangle: Σ x_i / 3 and (Σ x_i y_i + Σ x_i Σ y_i) / 12 of its area.
void add(const Piece& piece, Moments& moments) {
  const auto fraction = static_cast<double>(piece.fraction);
  std::array<double, 2> sum{};
  std::array<std::array<double, 2>, 2> products{};
  for (const std::array<float, 2>& corner : piece.corners)
    for (std::size_t i = 0; i < 2; ++i) {
      sum[i] += static_cast<double>(corner[i]);
      for (std::size_t k = 0; k < 2; ++k)
        products[i][k] += static_cast<double>(corner[i]) * static_cast<double>(corner[k]);
    }
  moments.area += fraction;
  moments.v += fraction * sum[0] / 3;
  moments.w += fraction * sum[1] / 3;
  moments.vv += fraction * (products[0][0] + sum[0] * sum[0]) / 12;
  moments.vw += fraction * (products[0][1] + sum[0] * sum[1]) / 12;
  moments.ww += fraction * (products[1][1] + sum[1] * sum[1]) / 12;
}

// Twice the area in the plane of v and w, where the whole triangle has 1/2.
double fractionOf(const Piece& piece) {
  const auto at = [&](std::size_t corner, std::size_t axis) {
    return static_cast<double>(piece.corners[corner][axis]);
  };
  return (at(1, 0) - at(0, 0)) * (at(2, 1) - at(0, 1)) -
         (at(2, 0) - at(0, 0)) * (at(1, 1) - at(0, 1));
}

// Over the whole triangle v and w have the mean 1/3, v² and w² 1/6, and vw 1/12. Halving is exact
// in binary, so these are exact too.
TEST(Subdivision, PiecesAddUpToEveryTriangle) {
  for (const Body& body : allBodies()) {
    const auto pieces = subdivide(body.surface(), body.spacing(0.1), plenty);
    ASSERT_TRUE(pieces) << body.name;
    std::vector<Moments> moments(body.triangles.size());
    for (const Piece& piece : *pieces) {
      ASSERT_LT(piece.triangle, body.triangles.size()) << body.name;
      // Of the same orientation as the triangle, and as large as it says.
      ASSERT_EQ(fractionOf(piece), static_cast<double>(piece.fraction)) << body.name;
      add(piece, moments[piece.triangle]);
    }
    for (const Moments& sum : moments) {
      ASSERT_EQ(sum.area, 1) << body.name;
      ASSERT_NEAR(sum.v, 1.0 / 3, 1e-14) << body.name;
      ASSERT_NEAR(sum.w, 1.0 / 3, 1e-14) << body.name;
      ASSERT_NEAR(sum.vv, 1.0 / 6, 1e-14) << body.name;
      ASSERT_NEAR(sum.vw, 1.0 / 12, 1e-14) << body.name;
      ASSERT_NEAR(sum.ww, 1.0 / 6, 1e-14) << body.name;
    }
  }
}

TEST(Subdivision, NoPieceIsLargerThanAskedForNorMuchSmaller) {
  for (const Body& body : allBodies())
    for (const double mm : {0.1, 0.3, 1e9}) {
      const auto pieces = subdivide(body.surface(), body.spacing(mm), plenty);
      ASSERT_TRUE(pieces) << body.name;
      for (const Piece& piece : *pieces) {
        const double size = sizeMm(placesOf(body, piece));
        ASSERT_LE(size, mm * (1 + 1e-6)) << body.name;
        // Halving the longest edge c of a triangle leaves (3a² + b²) / 2 of a² + b² + c² to the
        // half with the edge a. With c ≤ a + b that is least for a = b (√7 - 2) / 3: 0.2257 of it.
        if (piece.fraction < 1) {
          ASSERT_GT(size, std::sqrt(0.2257) * mm * (1 - 1e-6)) << body.name;
        }
      }
      if (mm > 1e6) {
        EXPECT_EQ(pieces->size(), body.triangles.size()) << body.name;
      }
    }
}

TEST(Subdivision, KnowsTheSizeOfATriangle) {
  const double height = std::sqrt(0.75);
  const Body equilateral{"equilateral",
                         {{0, 0, 0}, {1, 0, 0}, {0.5F, static_cast<float>(height), 0}},
                         {{0, 1, 2}},
                         {0}};
  EXPECT_NEAR(spacingOfMm(equilateral.surface(), 0), std::sqrt(0.5), 1e-6);
  for (const Body& body : allBodies())
    for (std::uint32_t t = 0; t < body.triangles.size(); ++t)
      ASSERT_DOUBLE_EQ(spacingOfMm(body.surface(), t),
                       sizeMm({cornerOf(body, t, 0), cornerOf(body, t, 1), cornerOf(body, t, 2)}));
}

TEST(Subdivision, EveryObjectHasItsOwnSpacing) {
  const Body body = bodyOf(awkward::twoObjects());
  const std::vector<double> spacing{0.03, 0.06};
  const auto pieces = subdivide(body.surface(), spacing, plenty);
  ASSERT_TRUE(pieces);
  std::array<double, 2> largest{};
  for (const Piece& piece : *pieces) {
    double& size = largest[body.objectOfTriangle[piece.triangle]];
    size = std::max(size, sizeMm(placesOf(body, piece)));
  }
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LE(largest[i], spacing[i] * (1 + 1e-6));
    EXPECT_GT(largest[i], spacing[i] / 2);
  }
}

TEST(Subdivision, GivesUpWhereThereWouldBeTooMany) {
  for (const Body& body : allBodies()) {
    const auto pieces = subdivide(body.surface(), body.spacing(0.1), plenty);
    ASSERT_TRUE(pieces) << body.name;
    if (pieces->empty()) continue;
    EXPECT_TRUE(subdivide(body.surface(), body.spacing(0.1), pieces->size())) << body.name;
    EXPECT_FALSE(subdivide(body.surface(), body.spacing(0.1), pieces->size() - 1)) << body.name;
  }
  // Ends at once, however fine the division should be.
  const Body body = sliver();
  for (const double mm : {1e-3, 1e-12, std::numeric_limits<double>::min()})
    EXPECT_FALSE(subdivide(body.surface(), body.spacing(mm), 1000));
}

}  // namespace
}  // namespace opaline::surfels
