#include "deform/deformer.h"
#include "deform/vectors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace opaline::deform {
namespace {

using scene::Double3;
using scene::operator+;
using scene::operator-;
using scene::operator*;

using std::numbers::pi;

/// 4 × 10 × 2, about the axis x = 1, z = −2, from y = 5: a diagonal of √120.
const Bounds box{{-1, 5, -3}, {3, 15, -1}};
const double diagonal = std::sqrt(120.0);

Double3 place(const Deformer& deformer, double seconds, const Double3& p) {
  return deformed(deformer, box, seconds, {p, {0, 1, 0}}).position;
}

/// The Jacobian of the map, by central differences.
std::array<Double3, 3> jacobian(const Deformer& deformer, double seconds, const Double3& p) {
  std::array<Double3, 3> columns{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Double3 step{};
    step[axis] = 1e-5;
    columns[axis] =
        (1 / 2e-5) * (place(deformer, seconds, p + step) - place(deformer, seconds, p - step));
  }
  return columns;
}

const std::vector<Deformer> some{
    {DeformerKind::Twist, 1.3F, 0},   {DeformerKind::Twist, -2, 3},
    {DeformerKind::Bend, 2, 0},       {DeformerKind::Bend, -1.5F, 2},
    {DeformerKind::Bend, 0, 0},       {DeformerKind::Squash, 0.6F, 0},
    {DeformerKind::Squash, -1.5F, 0}, {DeformerKind::Squash, 0.5F, 1},
    {DeformerKind::Wobble, 0.2F, 0},  {DeformerKind::Wobble, 0.1F, 1.7F}};
/// Points off the two heights where the wobble's swing has no second derivative.
const std::vector<Double3> points{{1, 5.1, -2}, {3, 14.9, -1}, {-1, 7, -3}, {2.5, 9.75, -1.25}};

TEST(Deformer, AmountsSwing) {
  const Deformer twist{DeformerKind::Twist, 2, 4};
  EXPECT_NEAR(amountAt(twist, 0), 0, 1e-12);
  EXPECT_NEAR(amountAt(twist, 1), 2, 1e-12);
  EXPECT_NEAR(amountAt(twist, 3), -2, 1e-12);
  EXPECT_NEAR(amountAt(twist, 4e9 + 1), 2, 1e-9);
  EXPECT_EQ(amountAt({DeformerKind::Twist, 2, 0}, 1.234), 2);
  EXPECT_EQ(amountAt({DeformerKind::Wobble, 0.5F, 4}, 0), 0.5);
}

TEST(Deformer, ATwistTurnsTheEndsAgainstEachOther) {
  const Deformer quarter{DeformerKind::Twist, static_cast<float>(pi), 0};
  // The top turns by a quarter about +y: +x goes to −z; the bottom back; the middle stays.
  expectVector(place(quarter, 0, {2, 15, -2}), {1, 15, -3});
  expectVector(place(quarter, 0, {2, 5, -2}), {1, 5, -1});
  expectVector(place(quarter, 0, {2, 10, -1.5}), {2, 10, -1.5});
}

TEST(Deformer, ABendMakesTheAxisAnArcOfItsAngle) {
  const double angle = pi / 2;
  const Deformer bend{DeformerKind::Bend, static_cast<float>(angle), 0};
  const double radius = 10 / angle;
  expectVector(place(bend, 0, {1, 5, -2}), {1, 5, -2});
  expectVector(place(bend, 0, {1, 15, -2}), {1 + radius, 5 + radius, -2});
  // Height becomes arc length along the axis.
  double length = 0;
  for (int i = 0; i < 1000; ++i) {
    length += scene::length(place(bend, 0, {1, 5.0 + 0.01 * (i + 1), -2}) -
                            place(bend, 0, {1, 5.0 + 0.01 * i, -2}));
  }
  EXPECT_NEAR(length, 10, 1e-5);
  // Points at the arc's centre coincide, whatever their height.
  expectVector(place(bend, 0, {1 + radius, 12, -2}), {1 + radius, 5, -2});
}

TEST(Deformer, ATinyBendIsNearlyNone) {
  for (const float amount : {0.0F, 1e-30F, 1e-12F, 1e-6F}) {
    expectVector(place({DeformerKind::Bend, amount, 0}, 0, {2, 13, -1}), {2, 13, -1}, 1e-4);
  }
  // To first order the axis leaves by κs²/2.
  const double aside = place({DeformerKind::Bend, 1e-6F, 0}, 0, {1, 15, -2})[0] - 1;
  EXPECT_NEAR(aside / (1e-7 * 100 / 2), 1, 1e-6);
}

TEST(Deformer, ASquashKeepsTheVolume) {
  const Deformer squash{DeformerKind::Squash, 0.75F, 0};
  expectVector(place(squash, 0, {1, 5, -2}), {1, 5, -2});
  expectVector(place(squash, 0, {3, 15, -1}), {5, 7.5, 0});  // a quarter as high, twice as wide
  const Deformer stretch{DeformerKind::Squash, -3, 0};
  expectVector(place(stretch, 0, {3, 15, -1}), {2, 45, -1.5});
}

TEST(Deformer, ASwingingSquashNeverTurnsInsideOut) {
  const Deformer wild{DeformerKind::Squash, -3, 4};  // +3 at 3 s
  const Double3 top = place(wild, 3, {3, 15, -1});
  EXPECT_NEAR(top[1], 6, 1e-6);
  EXPECT_TRUE(scene::isFinite(top));
}

TEST(Deformer, AWobbleLeavesTheFootAndTravelsUpwards) {
  const Deformer wobble{DeformerKind::Wobble, 0.1F, 2};
  for (const double t : {0.0, 0.3, 1.1}) expectVector(place(wobble, t, {2, 5, -1}), {2, 5, -1});
  // h = 1, t = 0: sin 2π = 0, cos 2π = 1; a quarter period later sin(−π/2) = −1.
  expectVector(place(wobble, 0, {1, 15, -2}), {1, 15, -2 + 0.05 * diagonal});
  expectVector(place(wobble, 0.5, {1, 15, -2}), {1 - 0.1 * diagonal, 15, -2});
  // h = ½: s = ½.
  expectVector(place(wobble, 0.5, {1, 10, -2}), {1 + 0.05 * diagonal, 10, -2});
  // Period 0 is one second.
  expectVector(place({DeformerKind::Wobble, 0.1F, 0}, 0.25, {1, 15, -2}),
               {1 - 0.1 * diagonal, 15, -2});
}

TEST(Deformer, VolumesAreThoseOfTheFormulas) {
  for (const Deformer& deformer : some) {
    for (const Double3& p : points) {
      const auto [x, y, z] = jacobian(deformer, 0.4, p);
      const double volume = scene::dot(x, scene::cross(y, z));
      const double expected =
          deformer.kind == DeformerKind::Bend ? 1 - amountAt(deformer, 0.4) / 10 * (p[0] - 1) : 1;
      EXPECT_NEAR(volume, expected, 1e-8);
    }
  }
}

TEST(Deformer, NormalsAreThoseOfMovedSurfaces) {
  for (const Deformer& deformer : some) {
    for (const Double3& p : points) {
      for (const Double3& normal :
           {Double3{1, 0, 0}, Double3{0, 1, 0}, Double3{0, 0, -1}, Double3{0.48, -0.6, 0.64}}) {
        // Two steps along the surface, and their images.
        const Double3 other = std::abs(normal[0]) > 0.9 ? Double3{0, 1, 0} : Double3{1, 0, 0};
        Double3 u = scene::cross(other, normal);
        u = (1 / scene::length(u)) * u;
        const Double3 v = scene::cross(normal, u);
        const auto [x, y, z] = jacobian(deformer, 0.4, p);
        const auto moved = [&](const Double3& d) { return d[0] * x + d[1] * y + d[2] * z; };
        const Double3 expected = scene::cross(moved(u), moved(v));
        const SurfacePoint actual = deformed(deformer, box, 0.4, {p, normal});
        expectVector(actual.normal, (1 / scene::length(expected)) * expected, 1e-7);
      }
    }
  }
}

TEST(Deformer, ABoxWithoutHeightStaysAsItIs) {
  const Bounds flat{{0, 1, 0}, {1, 1, 1}};
  for (const Deformer& deformer : some) {
    const SurfacePoint point = deformed(deformer, flat, 0.4, {{0.5, 1, 0.25}, {0, 1, 0}});
    EXPECT_EQ(point.position, (Double3{0.5, 1, 0.25}));
    EXPECT_EQ(point.normal, (Double3{0, 1, 0}));
  }
}

}  // namespace
}  // namespace opaline::deform
