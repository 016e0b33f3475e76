#include "compare/cie_color.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compare/color_map.h"

namespace opaline::compare {
namespace {

void expectNear(const Triple& value, const Triple& expected, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(value[i], expected[i], tolerance) << i;
}

// The widely published L*a*b* of the sRGB primaries under D65, to two decimals.
TEST(CieColor, PrimariesHaveTheirPublishedLab) {
  expectNear(lab({1, 0, 0}), {53.24, 80.09, 67.20}, 0.02);
  expectNear(lab({0, 1, 0}), {87.73, -86.18, 83.18}, 0.02);
  expectNear(lab({0, 0, 1}), {32.30, 79.19, -107.86}, 0.02);
  expectNear(lab({1, 1, 1}), {100, 0, 0}, 1e-9);
  expectNear(lab({0, 0, 0}), {0, 0, 0}, 1e-9);
}

TEST(CieColor, GoesBackTheWayItCame) {
  for (const Triple& rgb :
       {Triple{0.2, 0.5, 0.9}, Triple{0.001, 0.9, 0}, Triple{1, 0.001, 0.002}}) {
    expectNear(linearRgbFromLab(lab(rgb)), rgb, 1e-12);
    expectNear(linearRgbFromRelativeXyz(relativeXyz(rgb)), rgb, 1e-12);
  }
}

TEST(ColorMap, EqualStepsInLabThatRiseInLightness) {
  constexpr int steps = 256;
  double shortest = 1e9;
  double longest = 0;
  for (int i = 0; i < steps; ++i) {
    const Triple a = perceptualLab(i / static_cast<double>(steps));
    const Triple b = perceptualLab((i + 1) / static_cast<double>(steps));
    const double step = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    shortest = std::min(shortest, step);
    longest = std::max(longest, step);
    EXPECT_GT(b[0], a[0]);
  }
  EXPECT_LT(longest, 1.01 * shortest);
}

TEST(ColorMap, EveryColorIsOneAScreenShows) {
  for (int i = 0; i <= 1000; ++i) {
    for (const double channel : linearRgbFromLab(perceptualLab(i / 1000.0))) {
      EXPECT_GE(channel, 0) << i;
      EXPECT_LE(channel, 1) << i;
    }
  }
}

TEST(ColorMap, StaysAtItsEnds) {
  EXPECT_EQ(perceptualColor(-1), perceptualColor(0));
  EXPECT_EQ(perceptualColor(7), perceptualColor(1));
}

}  // namespace
}  // namespace opaline::compare
