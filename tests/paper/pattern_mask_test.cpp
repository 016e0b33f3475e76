#include "paper/pattern_mask.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace opaline::paper {
namespace {

using Profiles = std::array<bssrdf::Profile, 3>;
using Sums = std::array<double, 3>;

using std::numbers::pi;

Profiles profilesOf(const Medium& medium, bssrdf::Model model) {
  Profiles profiles;
  for (int c = 0; c < 3; ++c)
    profiles[static_cast<std::size_t>(c)] =
        bssrdf::makeProfile(model, bssrdf::coefficients(medium, c));
  return profiles;
}

// Jensen et al. 2001, Figure 5.
Medium marble() {
  return {"marble", {2.19, 2.62, 3.00}, {.0021, .0041, .0071}, 1.5};
}
Medium skin() {
  return {"skin1", {.74, .88, 1.01}, {.032, .17, .48}, 1.3};
}
Medium ketchup() {
  return {"ketchup", {.18, .07, .03}, {.061, .97, 1.45}, 1.3};
}

struct Offset {
  int x;
  int y;
};

Offset offsetOf(const shared::PatternEntry& entry) {
  const auto bits = std::bit_cast<std::uint32_t>(entry.value.a);
  return {static_cast<std::int16_t>(bits & 0xffffU), static_cast<std::int16_t>(bits >> 16U)};
}

// The contribution of a near sample in a plane under light of 1, as in lib/scatter.glsl.
double nearSample(const PatternMask& mask, const Profiles& profiles, std::size_t entry, int channel,
                  double texelMm) {
  const shared::PatternEntry& sample = mask.entries[entry];
  const Offset offset = offsetOf(sample);
  const double squared = (offset.x * offset.x + offset.y * offset.y) * texelMm * texelMm;
  return static_cast<double>(mask.entries[1].value.a) * texelMm * texelMm *
         profiles[static_cast<std::size_t>(channel)](
             std::sqrt(squared * static_cast<double>(sample.value[channel]) + mask.nearSquareMm2));
}

// The whole pattern in a plane under light of 1, as summed in lib/scatter.glsl and
// pattern_vertices.comp.glsl.
Sums sumInPlane(const PatternMask& mask, const Profiles& profiles, const PatternExtent& extent,
                double texelMm) {
  Sums sums{};
  const shared::PatternEntry& far = mask.entries[2 + mask.nearSamples];
  const double distanceMm = extent.distance * texelMm;
  for (int c = 0; c < 3; ++c) {
    double& sum = sums[static_cast<std::size_t>(c)];
    sum = static_cast<double>(mask.entries[0].value[c]);
    for (std::size_t i = 2; i < 2 + mask.nearSamples; ++i)
      sum += nearSample(mask, profiles, i, c, texelMm);
    sum += 8 * static_cast<double>(far.value.a) * texelMm * texelMm *
           profiles[static_cast<std::size_t>(c)](std::sqrt(
               distanceMm * distanceMm * static_cast<double>(far.value[c]) + mask.farSquareMm2));
  }
  return sums;
}

double outerRadiusMm(const PatternExtent& extent, double texelMm) {
  return std::max(2 * extent.distance - extent.blockRadius(), extent.blockRadius()) * texelMm;
}

// By the midpoint rule, for squares without the sharp middle of the profile.
double integralOverCell(const bssrdf::Profile& profile, double x, double y, double edge) {
  constexpr int steps = 60;
  double sum = 0;
  for (int j = 0; j < steps; ++j)
    for (int i = 0; i < steps; ++i)
      sum += profile(
          std::hypot(x + ((i + 0.5) / steps - 0.5) * edge, y + ((j + 0.5) / steps - 0.5) * edge));
  return sum * edge * edge / (steps * steps);
}

struct Case {
  Medium medium;
  double texelMm;
  PatternShape shape;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Medium& medium : {marble(), skin(), ketchup()}) {
    const double freePathMm = bssrdf::coefficients(medium, 1).meanFreePathMm;
    for (const double texel : {0.1, 0.5, 1.0, 5.0})
      for (const double spacing : {0.1, 0.7, 3.0})
        all.push_back({medium,
                       texel * freePathMm,
                       {.nearRings = 4,
                        .nearSpacingMm = spacing * freePathMm,
                        .farDistanceMm = 18 * std::max(spacing, texel) * freePathMm}});
  }
  return all;
}

// Eq. 4's integral over a disc. The near block is a square as large as its disc.
TEST(PatternMask, GivesTheClosedFormInAPlane) {
  for (const bssrdf::Model model : {bssrdf::Model::Dipole, bssrdf::Model::BetterDipole})
    for (const Case& one : cases()) {
      const Profiles profiles = profilesOf(one.medium, model);
      const PatternExtent extent = patternExtent(one.shape, one.texelMm, 1e9);
      const PatternMask mask = makePatternMask(profiles, extent, one.texelMm);
      const Sums sums = sumInPlane(mask, profiles, extent, one.texelMm);
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(sums[c] / profiles[c].disc(outerRadiusMm(extent, one.texelMm)), 1, 0.02)
            << one.medium.name << ", channel " << c << ", texel " << one.texelMm << " mm, spacing "
            << extent.spacing << ", model " << static_cast<int>(model);
    }
}

TEST(PatternMask, EveryNearSampleGivesWhatItsCellReflects) {
  for (const bssrdf::Model model : {bssrdf::Model::Dipole, bssrdf::Model::BetterDipole})
    for (const Case& one : cases()) {
      const Profiles profiles = profilesOf(one.medium, model);
      const PatternExtent extent = patternExtent(one.shape, one.texelMm, 1e9);
      const PatternMask mask = makePatternMask(profiles, extent, one.texelMm);
      const double edge = extent.spacing * one.texelMm;
      const double whole = profiles[1].totalReflectance();
      for (std::size_t i = 2; i < 2 + mask.nearSamples; i += 5) {
        const Offset offset = offsetOf(mask.entries[i]);
        for (int c = 0; c < 3; ++c) {
          const double expected =
              integralOverCell(profiles[static_cast<std::size_t>(c)], offset.x * one.texelMm,
                               offset.y * one.texelMm, edge);
          // Relative to the whole where the cell contributes almost nothing.
          EXPECT_NEAR(nearSample(mask, profiles, i, c, one.texelMm), expected,
                      0.01 * expected + 1e-4 * whole)
              << one.medium.name << ", channel " << c << ", texel " << one.texelMm << " mm, at "
              << offset.x << ' ' << offset.y << ", model " << static_cast<int>(model);
        }
      }
    }
}

TEST(PatternMask, NearSamplesFillASquareAroundTheCentre) {
  const Profiles profiles = profilesOf(marble(), bssrdf::Model::Dipole);
  const PatternExtent extent{.nearRings = 3, .spacing = 5, .distance = 40, .cell = 4};
  const PatternMask mask = makePatternMask(profiles, extent, 0.25);
  ASSERT_EQ(mask.nearSamples, 48U);
  ASSERT_EQ(mask.entries.size(), 51U);
  std::array<bool, 49> seen{};
  seen[24] = true;  // the centre
  for (std::size_t i = 2; i < 50; ++i) {
    const Offset offset = offsetOf(mask.entries[i]);
    ASSERT_EQ(offset.x % 5, 0);
    ASSERT_EQ(offset.y % 5, 0);
    ASSERT_LE(std::max(std::abs(offset.x), std::abs(offset.y)), 15);
    const auto at = static_cast<std::size_t>(7 * (offset.y / 5 + 3) + offset.x / 5 + 3);
    EXPECT_FALSE(seen[at]);
    seen[at] = true;
  }
  // The disc as large as the cell, and how fast it grows: d ln D(√(a/π)) / d ln a.
  const double area = std::pow(5 * 0.25, 2);
  const auto disc = [&](double a) { return profiles[0].disc(std::sqrt(a / pi)); };
  EXPECT_NEAR(mask.entries[0].value.r, disc(area), 1e-6);
  EXPECT_FLOAT_EQ(mask.entries[0].value.a, 0.25F * 0.25F);
  EXPECT_NEAR(mask.entries[1].value.r, std::log(disc(1.01 * area) / disc(0.99 * area)) / 0.02,
              1e-3);
  EXPECT_FLOAT_EQ(mask.entries[1].value.a, 25);
}

TEST(PatternMask, IsFiniteForExtremeMedia) {
  for (const double s : {1e-3, 1.0, 1e3})
    for (const double a : {0.0, 1e-3, 1.0, 1e3})
      for (const double texelMm : {1e-3, 1.0, 100.0})
        for (const int rings : {0, 4, 15})
          for (const bssrdf::Model model : {bssrdf::Model::Dipole, bssrdf::Model::BetterDipole}) {
            const Profiles profiles =
                profilesOf({"extreme", {s, 1e3, 1e-3}, {a, 1e-3, 1e3}, 1.4}, model);
            const PatternExtent extent = patternExtent(
                {.nearRings = rings, .nearSpacingMm = 0.5, .farDistanceMm = 9}, texelMm, 4000);
            const PatternMask mask = makePatternMask(profiles, extent, texelMm);
            const auto across = static_cast<std::uint32_t>(2 * rings + 1);
            ASSERT_EQ(mask.nearSamples, across * across - 1);
            ASSERT_EQ(mask.entries.size(), across * across + 2);
            ASSERT_LE(mask.entries.size(), shared::maxPatternEntries);
            ASSERT_TRUE(std::isfinite(mask.nearSquareMm2) && mask.nearSquareMm2 >= 0);
            ASSERT_TRUE(std::isfinite(mask.farSquareMm2) && mask.farSquareMm2 >= 0);
            for (std::size_t i = 0; i < mask.entries.size(); ++i) {
              for (int c = 0; c < 3; ++c) {
                const float value = mask.entries[i].value[c];
                ASSERT_TRUE(std::isfinite(value) && value >= 0)
                    << value << ", σ " << s << ' ' << a << ", entry " << i;
              }
            }
            for (const std::size_t i : {std::size_t{0}, std::size_t{1}, mask.entries.size() - 1}) {
              const float alpha = mask.entries[i].value.a;
              ASSERT_TRUE(std::isfinite(alpha) && alpha >= 0);
            }
            for (const double sum : sumInPlane(mask, profiles, extent, texelMm))
              ASSERT_TRUE(std::isfinite(sum) && sum >= 0);
          }
}

TEST(PatternMask, HasACentreAndARingWithoutNearSamples) {
  const Profiles profiles = profilesOf(marble(), bssrdf::Model::Dipole);
  const PatternExtent extent =
      patternExtent({.nearRings = 0, .nearSpacingMm = 0.4, .farDistanceMm = 2}, 0.1, 1e6);
  const PatternMask mask = makePatternMask(profiles, extent, 0.1);
  EXPECT_EQ(mask.nearSamples, 0U);
  ASSERT_EQ(mask.entries.size(), 3U);
  const Sums sums = sumInPlane(mask, profiles, extent, 0.1);
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(sums[c] / profiles[c].disc(outerRadiusMm(extent, 0.1)), 1, 1e-3);
}

TEST(PatternExtentTest, RoundsToTexelsAndKeepsFarSamplesOffTheBlock) {
  const PatternShape shape{.nearRings = 4, .nearSpacingMm = 1.02, .farDistanceMm = 9.9};
  const PatternExtent extent = patternExtent(shape, 0.5, 1e6);
  EXPECT_EQ(extent.nearRings, 4);
  EXPECT_EQ(extent.spacing, 2);
  EXPECT_EQ(extent.distance, 20);
  EXPECT_NEAR(extent.blockRadius() * extent.blockRadius() * pi, 18 * 18, 1e-9);
  EXPECT_GE(extent.nearReach(), 4 * 2);
  for (const double farMm : {0.0, 1.0, 3.0, 6.0}) {
    const PatternExtent near =
        patternExtent({.nearRings = 4, .nearSpacingMm = 1, .farDistanceMm = farMm}, 0.5, 1e6);
    EXPECT_GT(near.distance, near.blockRadius());
  }
}

// Neither the block nor the ring may be larger than a disc of the object's area.
TEST(PatternExtentTest, IsNoLargerThanTheObject) {
  for (const double areaMm2 : {1e-3, 0.5, 10.0, 300.0})
    for (const double texelMm : {0.01, 0.3, 2.0}) {
      const PatternShape shape{.nearRings = 4, .nearSpacingMm = 3, .farDistanceMm = 50};
      const PatternExtent extent = patternExtent(shape, texelMm, areaMm2);
      EXPECT_GE(extent.spacing, 1);
      EXPECT_GE(extent.cell, 1);
      const double radius = std::sqrt(areaMm2 / pi) / texelMm;
      if (extent.spacing > 1) {
        EXPECT_LE(extent.blockRadius(), radius);
      }
      if (extent.distance > std::ceil(extent.blockRadius()) + 1) {
        EXPECT_LE(2 * extent.distance - extent.blockRadius(), radius * (1 + 1e-9));
      }
    }
}

TEST(PatternExtentTest, FitsIntoItsReach) {
  for (const int rings : {0, 1, 4, 15})
    for (const int spacing : {1, 2, 7, 40})
      for (const int reach : {2, 3, 5, 16, 64, 1000}) {
        const PatternExtent asked{.nearRings = rings, .spacing = spacing, .distance = 99};
        const PatternExtent extent = fitted(asked, reach);
        EXPECT_LE(extent.nearReach(), reach);
        EXPECT_GE(extent.spacing, 1);
        EXPECT_GE(extent.nearRings, 0);
        if (asked.nearReach() <= reach) {
          EXPECT_EQ(extent.nearRings, rings);
          EXPECT_EQ(extent.spacing, spacing);
          continue;
        }
        // The next larger pattern, rings before spacing, must not fit.
        PatternExtent larger = extent;
        ++(extent.nearRings < rings ? larger.nearRings : larger.spacing);
        EXPECT_GT(larger.nearReach(), reach);
      }
  EXPECT_LE(fitted({.nearRings = 4, .spacing = 9}, 0).nearRings, 0);
}

}  // namespace
}  // namespace opaline::paper
