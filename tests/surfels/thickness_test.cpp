#include "surfels/thickness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "surfels/bodies.h"
#include "surfels/surfels.h"
#include "surfels/tree.h"

namespace opaline::surfels {
namespace {

using namespace test;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A body's surfels and the thickness of the body below them.
struct Measured {
  Measured(const Body& body, double spacingMm, std::size_t budget = 100'000)
      : surfels(makeSurfels(body.surface(), body.spacing(spacingMm), budget)),
        thickness(thicknessMm(body.surface(), surfels)) {}

  SurfelDivision surfels;
  std::vector<double> thickness;
};

Point middleOf(const Body& body, const Piece& piece) {
  const std::array<Point, 3> corners = placesOf(body, piece);
  Point middle{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    middle[axis] = (corners[0][axis] + corners[1][axis] + corners[2][axis]) / 3;
  return middle;
}

Point normalOf(const Body& body, std::uint32_t triangle) {
  Point normal = crossOf(body.surface(), triangle);
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  for (double& component : normal) component /= length;
  return normal;
}

/// Calls `check(middle, normal, thickness)` once a leaf, with its first surfel's first piece, after
/// all surfels of the leaf were found to share the thickness.
template <typename Check>
void forEachLeaf(const Body& body, const Measured& measured, const Check& check) {
  ASSERT_EQ(measured.thickness.size(), measured.surfels.count());
  std::uint32_t seen = 0;
  for (std::uint32_t node = 0; node < measured.surfels.tree.links.size(); ++node) {
    const NodeLink link = linkOf(measured.surfels.tree, node);
    if (!link.leaf) continue;
    seen += link.count;
    for (std::uint32_t i = 1; i < link.count; ++i)
      ASSERT_EQ(measured.thickness[link.first + i], measured.thickness[link.first]);
    const Piece& piece =
        measured.surfels.pieces[std::size_t{link.first} * measured.surfels.piecesPerSurfel];
    check(middleOf(body, piece), normalOf(body, piece.triangle), measured.thickness[link.first]);
  }
  EXPECT_EQ(seen, measured.surfels.count());
}

// Slivers on top of each other in one plane: rays meet the boxes of all parts but hit nothing. The
// test must end soon.
TEST(Thickness, EndsWhereThousandsOfPartsOverlap) {
  Body body;
  constexpr std::uint32_t slivers = 1500;
  for (std::uint32_t i = 0; i < slivers; ++i) {
    const float x = static_cast<float>(i) / slivers;
    const auto first = static_cast<std::uint32_t>(body.positions.size());
    body.positions.insert(body.positions.end(), {{x, 0, 0}, {x + 1e-3F, 0, 0}, {100 * x, 100, 0}});
    body.triangles.push_back({first, first + 1, first + 2});
    body.objectOfTriangle.push_back(0);
  }
  for (const double mm : Measured(body, 0.5).thickness) EXPECT_GT(mm, 0);
}

TEST(Thickness, OfABoxAndASlabIsTheWayToTheOtherSide) {
  for (const Point& size : {Point{10, 6, 4}, {20, 1, 20}, {0.1, 5, 30}}) {
    const Body body =
        box(static_cast<float>(size[0]), static_cast<float>(size[1]), static_cast<float>(size[2]));
    for (const double spacing : {0.7, 100.0}) {
      forEachLeaf(body, Measured(body, spacing), [&](const Point&, const Point& normal, double mm) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          if (std::abs(normal[axis]) < 0.5) continue;
          ASSERT_NEAR(mm, size[axis], 1e-5 * size[axis]);
        }
      });
    }
  }
}

/// Expects the diameters of a sphere of radius 1. Triangles without area at its poles have no
/// direction.
void expectDiameters(const Body& body, const Measured& measured, double belowMm) {
  forEachLeaf(body, measured, [&](const Point&, const Point& normal, double mm) {
    if (std::isnan(normal[0])) {
      ASSERT_EQ(mm, infinity);
    } else {
      ASSERT_GT(mm, 2 - 2 * belowMm);
      ASSERT_LE(mm, 2);
    }
  });
}

// Facets lie up to 1 - cos(pi / 24) below the sphere, at both ends of the ray.
TEST(Thickness, OfASphereIsItsDiameter) {
  const Body body = bodyOf(awkward::sphere());
  expectDiameters(body, Measured(body, 0.1), 0.009);
}

// More triangles than surfels are allowed: the middle of a surfel's first piece counts.
TEST(Thickness, OfSurfelsOfSeveralPieces) {
  const Body body = bodyOf(awkward::sphere("fine", 96, 48));
  const Measured measured(body, 0.02, 1000);
  EXPECT_GT(measured.surfels.piecesPerSurfel, 1U);
  expectDiameters(body, measured, 0.0025);
}

TEST(Thickness, OfAWedgeGrowsAlongIt) {
  const Body body = wedge(10, 0.5F, 4.5F, 3);
  const double slope = 0.4;
  forEachLeaf(body, Measured(body, 0.3), [&](const Point& middle, const Point& normal, double mm) {
    if (normal[1] < -0.99) {
      ASSERT_NEAR(mm, 0.5 + slope * middle[0], 1e-5);
    }
    // From the slope down to the bottom, unless the end at x = 10 is met before.
    if (normal[1] > 0.5) {
      const double down = middle[1] / normal[1];
      const double along = (10 - middle[0]) / -normal[0];
      ASSERT_NEAR(mm, normal[0] < 0 ? std::min(down, along) : down, 1e-4);
    }
  });
}

TEST(Thickness, OfWhatHasNoOtherSideIsInfinite) {
  for (const Body& body : {bodyOf(awkward::flatSheet()), bodyOf(awkward::oneTriangle()), sliver(),
                           bodyOf(awkward::onlyDegenerate())}) {
    const Measured measured(body, 0.3);
    ASSERT_GT(measured.surfels.count(), 0U) << body.name;
    for (const double mm : measured.thickness) ASSERT_EQ(mm, infinity) << body.name;
  }
}

TEST(Thickness, IsThatOfTheSameObject) {
  // A small box within reach of a large one, which must not affect it.
  Body small = box(2, 2, 2);
  for (Vec3& p : small.positions)
    for (float& x : p) x += 4;
  const Body large = box(10, 10, 10);
  const Body both = together(large, small);
  const Measured measured(both, 0.5);
  const std::uint32_t first = measured.surfels.firstOfObject[1];
  for (std::uint32_t i = 0; i < measured.surfels.count(); ++i)
    ASSERT_NEAR(measured.thickness[i], i < first ? 10 : 2, 1e-5);

  // As one object: what faces the small box's sides is as far as these.
  Body one = both;
  one.objectOfTriangle.assign(one.triangles.size(), 0);
  one.objects = 1;
  double least = infinity;
  for (const double mm : Measured(one, 0.5).thickness) least = std::min(least, mm);
  EXPECT_NEAR(least, 2, 1e-5);
}

TEST(Thickness, OfAnyBodyIsPositiveOrInfinite) {
  for (const Body& body : allBodies()) {
    const Measured measured(body, 0.2, 5000);
    for (const double mm : measured.thickness) ASSERT_GT(mm, 0) << body.name;
  }
}

}  // namespace
}  // namespace opaline::surfels
