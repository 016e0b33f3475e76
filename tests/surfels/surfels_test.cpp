#include "surfels/surfels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "surfels/bodies.h"

namespace opaline::surfels {
namespace {

using namespace test;

void expectPartition(const Body& body, const SurfelDivision& made) {
  ASSERT_EQ(made.firstOfObject.size(), body.objects + 1) << body.name;
  ASSERT_EQ(made.tree.rootOfObject.size(), body.objects + 1) << body.name;
  ASSERT_EQ(made.pieces.size(), std::size_t{made.count()} * made.piecesPerSurfel) << body.name;
  std::vector<double> fraction(body.triangles.size(), 0);
  std::vector<std::array<double, 2>> moment(body.triangles.size());
  for (std::size_t object = 0; object < body.objects; ++object) {
    std::uint32_t empty = 0;
    for (std::size_t i = std::size_t{made.firstOfObject[object]} * made.piecesPerSurfel;
         i < std::size_t{made.firstOfObject[object + 1]} * made.piecesPerSurfel; ++i) {
      const Piece& piece = made.pieces[i];
      ASSERT_LT(piece.triangle, body.triangles.size()) << body.name;
      ASSERT_EQ(body.objectOfTriangle[piece.triangle], object) << body.name;
      empty += piece.fraction == 0 ? 1 : 0;
      fraction[piece.triangle] += static_cast<double>(piece.fraction);
      for (std::size_t axis = 0; axis < 2; ++axis)
        for (const std::array<float, 2>& corner : piece.corners)
          moment[piece.triangle][axis] +=
              static_cast<double>(piece.fraction) * static_cast<double>(corner[axis]) / 3;
    }
    EXPECT_LT(empty, made.piecesPerSurfel) << body.name;
  }
  for (std::size_t t = 0; t < fraction.size(); ++t) {
    ASSERT_EQ(fraction[t], 1) << body.name;
    for (const double mean : moment[t]) ASSERT_NEAR(mean, 1.0 / 3, 1e-12) << body.name;
  }
}

void expectPermutation(std::vector<std::uint32_t> order, std::size_t count) {
  ASSERT_EQ(order.size(), count);
  std::sort(order.begin(), order.end());
  for (std::uint32_t i = 0; i < order.size(); ++i) ASSERT_EQ(order[i], i);
}

void expectSizes(const Body& body, const SurfelDivision& made, const std::vector<double>& wanted) {
  ASSERT_EQ(made.spacingOfObjectMm.size(), body.objects);
  for (std::size_t i = 0; i < body.objects; ++i)
    EXPECT_GE(made.spacingOfObjectMm[i], wanted[i]) << body.name;
  for (const Piece& piece : made.pieces)
    ASSERT_LE(sizeMm(placesOf(body, piece)),
              made.spacingOfObjectMm[body.objectOfTriangle[piece.triangle]] * (1 + 1e-6))
        << body.name;
}

TEST(Surfels, AreTheWholeSurfaceWithinTheBudget) {
  for (const Body& body : allBodies())
    for (const std::size_t budget : {16U, 64U, 1000U, 20'000U}) {
      const SurfelDivision made = makeSurfels(body.surface(), body.spacing(0.02), budget);
      EXPECT_LE(made.count(), budget) << body.name;
      expectPartition(body, made);
      expectPermutation(made.vertexOrder, body.positions.size());
      expectSizes(body, made, body.spacing(0.02));
      if (HasFailure()) FAIL() << body.name << ", " << budget;
    }
}

double areaOf(const Body& body) {
  double sum = 0;
  for (std::uint32_t t = 0; t < body.triangles.size(); ++t) {
    const double a = distance(cornerOf(body, t, 0), cornerOf(body, t, 1));
    const double b = distance(cornerOf(body, t, 1), cornerOf(body, t, 2));
    const double c = distance(cornerOf(body, t, 2), cornerOf(body, t, 0));
    const double s = (a + b + c) / 2;
    sum += std::sqrt(std::max(0.0, s * (s - a) * (s - b) * (s - c)));  // Heron
  }
  return sum;
}

TEST(Surfels, AreAsFineAsAskedWhereTheBudgetAllows) {
  const Body body = bodyOf(awkward::torus());
  const double wanted = 0.1;
  const SurfelDivision made = makeSurfels(body.surface(), body.spacing(wanted), 100'000);
  EXPECT_EQ(made.piecesPerSurfel, 1U);
  EXPECT_EQ(made.spacingOfObjectMm, body.spacing(wanted));
  // At most four times as many as squares of that edge: a half has half the area, and at least half
  // the size of its parent.
  EXPECT_LT(made.count(), 4 * areaOf(body) / (wanted * wanted));
}

TEST(Surfels, MostOfABudgetThatBindsIsUsed) {
  for (const awkward::Shape& shape :
       {awkward::flatSheet(), awkward::openSheet(), awkward::torus()}) {
    const Body body = bodyOf(shape);
    for (const std::size_t budget : {10'000U, 30'000U, 77'777U}) {
      const SurfelDivision made = makeSurfels(body.surface(), body.spacing(1e-3), budget);
      EXPECT_LE(made.count(), budget) << body.name;
      // Equal triangles are all halved at once.
      EXPECT_GT(made.count(), 0.45 * static_cast<double>(budget)) << body.name;
      EXPECT_GT(made.spacingOfObjectMm[0], 1e-3);
    }
  }
}

std::vector<std::uint32_t> countOfObjects(const SurfelDivision& made) {
  std::vector<std::uint32_t> counts(made.firstOfObject.size());
  std::adjacent_difference(made.firstOfObject.begin(), made.firstOfObject.end(), counts.begin());
  counts.erase(counts.begin());
  return counts;
}

TEST(Surfels, ALargeObjectTakesNothingFromASmallOne) {
  const Body body = bodyOf(awkward::twoObjects());
  const std::vector<std::uint32_t> alone =
      countOfObjects(makeSurfels(body.surface(), std::vector<double>{1e9, 0.02}, 1'000'000));
  const SurfelDivision made =
      makeSurfels(body.surface(), std::vector<double>{1e-4, 0.02}, 4 * alone[1]);
  EXPECT_EQ(made.spacingOfObjectMm[1], 0.02);
  EXPECT_EQ(countOfObjects(made)[1], alone[1]);
  EXPECT_GT(made.spacingOfObjectMm[0], 1e-4);
  EXPECT_GT(countOfObjects(made)[0], alone[1]);
}

TEST(Surfels, ObjectsThatAllWantMoreThanTheirShareGetAboutAsMany) {
  const Body body = bodyOf(awkward::twoObjects());
  const std::vector<std::uint32_t> counts =
      countOfObjects(makeSurfels(body.surface(), std::vector<double>{1e-4, 4e-4}, 20'000));
  // Equal triangles are all halved at once.
  EXPECT_GT(counts[0], counts[1] / 2);
  EXPECT_LT(counts[0], counts[1] * 2);
  EXPECT_GT(counts[0] + counts[1], 20'000U * 45 / 100);
}

TEST(Surfels, JoinTrianglesWhereThereAreMoreThanTheBudget) {
  const Body body = bodyOf(awkward::sphere("fine sphere", 200, 100));
  for (const std::size_t budget : {1000U, 3000U, 30'000U}) {
    const SurfelDivision made = makeSurfels(body.surface(), body.spacing(1e-3), budget);
    EXPECT_GT(made.piecesPerSurfel, 1U);
    EXPECT_LE(made.count(), budget);
    EXPECT_GT(made.count(), 0.2 * static_cast<double>(budget));
    expectPartition(body, made);
    // As large as the surface divided by their number, or as a triangle.
    EXPECT_GE(made.spacingOfObjectMm[0], std::sqrt(areaOf(body) / made.count()) * (1 - 1e-6));
  }
}

// The last surfel of every object is only partly filled.
TEST(Surfels, KeepTheBudgetWhereEveryObjectsLastSurfelIsNotFull) {
  Body body = bodyOf(awkward::openSheet());
  body.objects = 40;
  for (std::size_t t = 0; t < body.triangles.size(); ++t)
    body.objectOfTriangle[t] = static_cast<std::uint32_t>(t * body.objects / body.triangles.size());
  for (const std::size_t budget : {100U, 333U, 1024U, 2000U, 3000U}) {
    const SurfelDivision made = makeSurfels(body.surface(), body.spacing(1e-4), budget);
    EXPECT_LE(made.count(), budget);
    expectPartition(body, made);
  }
}

// As many pieces as triangles, and at most one partly filled surfel per object.
TEST(Surfels, OfAsManyObjectsAsTheBudgetTakeNoMoreThanTheyNeed) {
  Body body{.name = "grains", .objects = 1000};
  for (std::uint32_t object = 0; object < body.objects; ++object) {
    for (std::uint32_t i = 0; i < 9; ++i) {
      const auto first = static_cast<std::uint32_t>(body.positions.size());
      const auto x = static_cast<float>(object);
      const auto y = static_cast<float>(i);
      body.positions.insert(body.positions.end(), {{x, y, 0}, {x + 0.5F, y, 0}, {x, y + 0.5F, 0}});
      body.triangles.push_back({first, first + 1, first + 2});
      body.objectOfTriangle.push_back(object);
    }
  }
  const SurfelDivision made = makeSurfels(body.surface(), body.spacing(10), 1024);
  EXPECT_EQ(made.count(), 1000U);
  EXPECT_EQ(made.piecesPerSurfel, 16U);
  expectPartition(body, made);
}

// Up to nine hundred million times finer than what fits: the division must end soon.
TEST(Surfels, EndHoweverFineTheyWereToBe) {
  for (Body body : allBodies()) {
    for (const float scale : {1e-6F, 1.0F, 1e6F}) {
      for (Vec3& p : body.positions)
        for (float& x : p) x *= scale;
      for (const double mm : {1e-9, 1e-30, 1e30}) {
        const SurfelDivision made = makeSurfels(body.surface(), body.spacing(mm), 1024);
        EXPECT_LE(made.count(), 1024U) << body.name;
        expectPartition(body, made);
      }
    }
  }
}

bool same(const Piece& a, const Piece& b) {
  return a.triangle == b.triangle && a.corners == b.corners && a.fraction == b.fraction;
}

TEST(Surfels, AreAlwaysTheSame) {
  for (const Body& body : allBodies()) {
    const SurfelDivision one = makeSurfels(body.surface(), body.spacing(0.05), 3000);
    const SurfelDivision other = makeSurfels(body.surface(), body.spacing(0.05), 3000);
    EXPECT_TRUE(std::equal(one.pieces.begin(), one.pieces.end(), other.pieces.begin(),
                           other.pieces.end(), same))
        << body.name;
    EXPECT_EQ(one.firstOfObject, other.firstOfObject);
    EXPECT_EQ(one.tree.links, other.tree.links);
    EXPECT_EQ(one.vertexOrder, other.vertexOrder);
  }
}

// Vertices numbered at random, edges of 0.1: the next in the order is a few edges away at most, in
// the mean.
TEST(Surfels, VerticesThatFollowEachOtherAreNeighbours) {
  Body body = bodyOf(awkward::flatSheet());
  std::vector<std::uint32_t> numbers(body.positions.size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  std::shuffle(numbers.begin(), numbers.end(), std::mt19937(4));
  std::vector<Vec3> positions(body.positions.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) positions[numbers[i]] = body.positions[i];
  body.positions = positions;
  for (Triangle& t : body.triangles)
    for (std::uint32_t& vertex : t) vertex = numbers[vertex];
  const SurfelDivision made = makeSurfels(body.surface(), body.spacing(0.05), 10'000);
  double sum = 0;
  for (std::size_t i = 1; i < made.vertexOrder.size(); ++i) {
    const Vec3& a = body.positions[made.vertexOrder[i - 1]];
    const Vec3& b = body.positions[made.vertexOrder[i]];
    sum += static_cast<double>(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
  }
  EXPECT_LT(sum / static_cast<double>(made.vertexOrder.size()), 0.3);
}

// A vertex without triangles comes last; an empty body has no surfels.
TEST(Surfels, OfNothingAreNone) {
  const Body body = bodyOf(awkward::empty());
  const SurfelDivision made = makeSurfels(body.surface(), body.spacing(1), 1024);
  EXPECT_EQ(made.count(), 0U);
  EXPECT_TRUE(made.tree.links.empty());
  Body lonely = bodyOf(awkward::oneTriangle());
  lonely.positions.insert(lonely.positions.begin(), {{9, 9, 9}});
  lonely.triangles = {{1, 2, 3}};
  EXPECT_EQ(makeSurfels(lonely.surface(), lonely.spacing(1), 1024).vertexOrder.back(), 0U);
}

}  // namespace
}  // namespace opaline::surfels
