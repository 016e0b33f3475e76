#include "lights/spot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace opaline {
namespace {

double cosineOf(double degrees) {
  return std::cos(degrees * std::numbers::pi / 180);
}

TEST(SpotFalloff, IsThatOfTheExtension) {
  const SpotFalloff falloff = falloffOf({.innerDegrees = 30, .outerDegrees = 60});
  EXPECT_EQ(falloff(1), 1);
  EXPECT_NEAR(falloff(cosineOf(30)), 1, 1e-12);
  EXPECT_NEAR(falloff(cosineOf(60)), 0, 1e-12);
  EXPECT_EQ(falloff(cosineOf(61)), 0);
  EXPECT_EQ(falloff(-1), 0);
  // Half-way between the two cosines it is (1/2)².
  EXPECT_NEAR(falloff((cosineOf(30) + 0.5) / 2), 0.25, 1e-12);
  // (cos 45° - cos 60°)² / (cos 30° - cos 60°)²
  EXPECT_NEAR(falloff(std::sqrt(0.5)), 0.320159, 1e-6);
}

TEST(SpotFalloff, OfEqualAnglesTakesAThousandthOfTheCosine) {
  const SpotFalloff falloff = falloffOf({.innerDegrees = 60, .outerDegrees = 60});
  EXPECT_NEAR(falloff(0.5005), 0.25, 1e-9);
  EXPECT_NEAR(falloff(0.501), 1, 1e-9);
  EXPECT_EQ(falloff(0.4999), 0);
}

TEST(SpotFalloff, OfAHemisphereEndsAtItsRim) {
  const SpotFalloff falloff = falloffOf({.innerDegrees = 0, .outerDegrees = 90});
  EXPECT_NEAR(falloff(0.5), 0.25, 1e-12);
  EXPECT_NEAR(falloff(0), 0, 1e-12);
}

}  // namespace
}  // namespace opaline
