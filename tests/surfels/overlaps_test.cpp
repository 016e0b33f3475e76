#include "surfels/overlaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "icosphere.h"
#include "surfels/bodies.h"
#include "surfels/surfels.h"

namespace opaline::surfels {
namespace {

using namespace test;
using opaline::test::icosphere;
using opaline::test::Icosphere;

constexpr double pi = std::numbers::pi;

Body noBody() {
  return {"parts", {}, {}, {}, 1};
}

/// Adds a ball at that place of the x axis; inside out if it is a cavity.
void addBall(Body& body, double x, double radius, bool cavity = false) {
  const Icosphere ball = icosphere(4);
  const auto first = static_cast<std::uint32_t>(body.positions.size());
  for (const auto& direction : ball.directions)
    body.positions.push_back({static_cast<float>(x + radius * direction[0]),
                              static_cast<float>(radius * direction[1]),
                              static_cast<float>(radius * direction[2])});
  for (Triangle triangle : ball.triangles) {
    for (std::uint32_t& corner : triangle) corner += first;
    if (cavity) std::swap(triangle[1], triangle[2]);
    body.triangles.push_back(triangle);
  }
  body.objectOfTriangle.resize(body.triangles.size(), 0);
}

/// What is left of the surface, and of that of parts beyond an x.
struct Left {
  double areaMm2 = 0;
  double beyondMm2 = 0;
};

Left leftOf(const Body& body, double x = 0) {
  const core::RestSurface surface = body.surface();
  const Overlaps overlaps(surface, std::vector<bool>(body.triangles.size(), true));
  const SurfelDivision made = makeSurfels(surface, body.spacing(0.05), 200'000, {}, overlaps);
  Left left;
  for (const Piece& piece : made.pieces) {
    left.areaMm2 += areaMm2(surface, piece);
    if (static_cast<double>(middleOfMm(surface, piece)[0]) > x)
      left.beyondMm2 += areaMm2(surface, piece);
  }
  return left;
}

// Two spheres of radius 1 whose middles are d apart lose caps of the height 1 - d/2.
TEST(OverlapsTest, CapsWithinTheOtherBallVanish) {
  for (const double d : {0.5, 1.0, 1.6}) {
    Body body = noBody();
    addBall(body, 0, 1);
    addBall(body, d, 1);
    const Left left = leftOf(body, d / 2);
    const double each = 4 * pi - 2 * pi * (1 - d / 2);
    EXPECT_NEAR(left.areaMm2, 2 * each, 0.01 * 2 * each) << d;
    EXPECT_NEAR(left.beyondMm2, each, 0.02 * each) << d;
  }
}

TEST(OverlapsTest, ABallWithinABallVanishes) {
  Body body = noBody();
  addBall(body, 0, 1);
  addBall(body, 0.2, 0.5);
  EXPECT_NEAR(leftOf(body).areaMm2, 4 * pi, 0.01 * 4 * pi);
}

TEST(OverlapsTest, ACavityStaysAndSoDoesWhatFloatsInIt) {
  Body body = noBody();
  addBall(body, 0, 1);
  addBall(body, 0, 0.9, true);
  addBall(body, 0.2, 0.5);
  const double all = 4 * pi * (1 + 0.81 + 0.25);
  EXPECT_NEAR(leftOf(body).areaMm2, all, 0.01 * all);
}

TEST(OverlapsTest, PartsThatAreApartStay) {
  Body body = noBody();
  addBall(body, 0, 1);
  addBall(body, 2.01, 1);
  EXPECT_FALSE(Overlaps(body.surface(), std::vector<bool>(body.triangles.size(), true))
                   .isWithin(0, {0, 0, 0}, {1, 0, 0}));
  EXPECT_NEAR(leftOf(body).areaMm2, 8 * pi, 0.01 * 8 * pi);
}

// A box against the middle of a larger one: both lose the face of the smaller one.
TEST(OverlapsTest, FacesThatTouchVanish) {
  Body body = box(1, 1, 1);
  const Body other = box(1, 2, 2);
  for (const Vec3& p : other.positions)
    body.positions.push_back({p[0] + 1, p[1] - 0.5F, p[2] - 0.5F});
  for (const Triangle& t : other.triangles)
    body.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  body.objectOfTriangle.resize(body.triangles.size(), 0);
  EXPECT_NEAR(leftOf(body).areaMm2, 6 + 16 - 2, 0.1);
}

// Boxes that share the corners of a face, too.
TEST(OverlapsTest, BoxesSideBySideAreOneBody) {
  Body body = box(1, 1, 1);
  const Body other = box(1, 1, 1);
  for (const Vec3& p : other.positions) body.positions.push_back({p[0] + 1, p[1], p[2]});
  for (const Triangle& t : other.triangles)
    body.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  body.objectOfTriangle.resize(body.triangles.size(), 0);
  EXPECT_NEAR(leftOf(body).areaMm2, 10, 0.01);
}

// Each is a body of its own, with its own medium.
TEST(OverlapsTest, ObjectsThatOverlapStayWhole) {
  Body body = together(box(1, 1, 1), box(2, 0.5F, 0.5F));
  EXPECT_FALSE(Overlaps(body.surface(), std::vector<bool>(body.triangles.size(), true)).any());
  EXPECT_NEAR(leftOf(body).areaMm2, 6 + 4.5, 0.01);
}

TEST(OverlapsTest, OpenPartsStayWhole) {
  Body body = noBody();
  addBall(body, 0, 1);
  addBall(body, 0.2, 0.5);
  std::vector<bool> boundsMedium(body.triangles.size(), true);
  for (std::size_t t = boundsMedium.size() / 2; t < boundsMedium.size(); ++t)
    boundsMedium[t] = false;
  EXPECT_FALSE(Overlaps(body.surface(), boundsMedium).any());
}

// Thousands of parts in one place: more pairs than are compared.
TEST(OverlapsTest, ManyPartsAreOneBody) {
  Body body = noBody();
  const Body one = box(1, 1, 1);
  for (int i = 0; i < 3000; ++i) {
    const auto first = static_cast<std::uint32_t>(body.positions.size());
    const float shift = 1e-3F * static_cast<float>(i);
    for (const Vec3& p : one.positions) body.positions.push_back({p[0] + shift, p[1], p[2]});
    for (const Triangle& t : one.triangles)
      body.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  body.objectOfTriangle.resize(body.triangles.size(), 0);
  const core::RestSurface surface = body.surface();
  const Overlaps overlaps(surface, std::vector<bool>(body.triangles.size(), true));
  EXPECT_FALSE(overlaps.isWithin(0, {0, 0.3, 0.4}, {-1, 0, 0}));
  EXPECT_TRUE(overlaps.isWithin(0, {1, 0.3, 0.4}, {1, 0, 0}));
}

}  // namespace
}  // namespace opaline::surfels
