#include "lights/area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bssrdf/fresnel.h"
#include "lights/fresnel_lobes.h"
#include "lights/reflection_lobe.h"

namespace opaline {
namespace {

using std::numbers::pi;

TEST(AreaLight, PlacesAreOnItAndEven) {
  const std::vector<AreaLight> lights{
      RectangleLight{{1, 2, 3}, {2, 0, 0}, {0, 3, 0}}, DiscLight{{1, 2, 3}, {0, 0.6F, 0.8F}, 4},
      SphereLight{{1, 2, 3}, 4}, TubeLight{{1, 2, -2}, {1, 2, 8}, 0.5F}};
  const std::vector<double> areas{24, 16 * pi, 64 * pi, 2 * pi * 0.5 * 10};
  const std::vector<double> reaches{std::sqrt(13.0), 4, 4, std::hypot(5, 0.5)};
  for (std::size_t i = 0; i < lights.size(); ++i) {
    EXPECT_NEAR(areaMm2(lights[i]), areas[i], 1e-4);
    EXPECT_NEAR(reachMm(lights[i]), reaches[i], 1e-6);
    const std::array<double, 3> middle = middleOf(lights[i]);
    EXPECT_NEAR(middle[0], 1, 1e-6);
    EXPECT_NEAR(middle[1], 2, 1e-6);
    EXPECT_NEAR(middle[2], 3, 1e-6);
    constexpr int steps = 16;
    std::array<double, 3> mean{};
    for (int k = 0; k < steps * steps; ++k) {
      const int row = k / steps;
      const AreaPoint place = pointOn(lights[i], (k % steps + 0.5) / steps, (row + 0.5) / steps);
      double away = 0;
      double normal = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        mean[axis] += place.positionMm[axis] / (steps * steps);
        away += std::pow(place.positionMm[axis] - middle[axis], 2);
        normal += std::pow(place.normal[axis], 2);
      }
      ASSERT_LE(std::sqrt(away), reaches[i] + 1e-6);
      ASSERT_NEAR(normal, 1, 1e-6);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(mean[axis], middle[axis], 1e-5);
  }
}

TEST(AreaLight, IsMetWhereALineMeetsIt) {
  const std::array<double, 3> from{0, 0, 10};
  const std::array<double, 3> down{0, 0, -1};
  const std::array<double, 3> aslant{0.6, 0, -0.8};
  // Down along z: a sphere is met a radius before its middle, a tube across the way as well.
  EXPECT_NEAR(distanceAlong(from, down, SphereLight{{0, 0, 1}, 4}).value(), 5, 1e-9);
  EXPECT_NEAR(distanceAlong(from, aslant, SphereLight{{6, 0, 2}, 4}).value(), 6, 1e-6);
  EXPECT_FALSE(distanceAlong(from, down, SphereLight{{4.01F, 0, 0}, 4}));
  EXPECT_FALSE(distanceAlong(from, down, SphereLight{{0, 0, 20}, 4}));
  EXPECT_NEAR(distanceAlong(from, down, TubeLight{{-5, 0, 0}, {5, 0, 0}, 2}).value(), 8, 1e-9);
  // Aslant it goes 2 mm down for every 1.5 mm along the axis, and meets the side 8 mm below.
  EXPECT_NEAR(distanceAlong(from, aslant, TubeLight{{-5, 0, 0}, {7, 0, 0}, 2}).value(), 10, 1e-6);
  EXPECT_FALSE(distanceAlong(from, aslant, TubeLight{{-5, 0, 0}, {5, 0, 0}, 2}));
  EXPECT_FALSE(distanceAlong(from, down, TubeLight{{0, 0, -5}, {0, 0, 5}, 2}));
  // A disc and a leaning parallelogram, from the front, from behind, and beside their edges.
  EXPECT_NEAR(distanceAlong(from, aslant, DiscLight{{6, 0, 2}, {0, 0, 1}, 1}).value(), 10, 1e-6);
  EXPECT_FALSE(distanceAlong(from, aslant, DiscLight{{7.01F, 0, 2}, {0, 0, 1}, 1}));
  EXPECT_FALSE(distanceAlong(from, aslant, DiscLight{{6, 0, 2}, {0, 0, -1}, 1}));
  EXPECT_TRUE(distanceAlong(from, aslant, DiscLight{{6, 0, 2}, {0, 0, -1}, 1, {1, 1, 1}, true}));
  const RectangleLight leaning{{3, 3, 0}, {2, 0, 0}, {2, 3.5F, 0}};
  EXPECT_NEAR(distanceAlong(from, down, leaning).value(), 10, 1e-6);
  RectangleLight further = leaning;
  further.centreMm = {3.4F, 3, 0};  // its corner is at (-0.6, -0.5), its edge runs by (-0.31, 0)
  EXPECT_FALSE(distanceAlong({-0.4, 0, 10}, down, further));
  EXPECT_TRUE(distanceAlong({-0.2, 0, 10}, down, further));
}

TEST(FresnelLobes, AreNearToTheTransmittanceAndKeepItsMean) {
  for (const double eta : {1.01, 1.3, 1.4, 1.5, 2.0, 3.0}) {
    const FresnelLobes lobes = fresnelLobesOf(eta);
    EXPECT_NEAR(lobes.plain + lobes.wide, bssrdf::meanTransmittance(eta), 1e-9);
    for (double cosine = 0.005; cosine < 1; cosine += 0.01) {
      const double exact = (1 - bssrdf::fresnelReflectance(eta, cosine)) * cosine;
      ASSERT_NEAR(lobes(cosine), exact, 0.0066) << eta << ' ' << cosine;
    }
  }
}

// Along the normal, and for lobes that are narrow, half vectors turn half as far as what is
// mirrored: GGX of α is a cosine lobe widened to 2α. From the side it is narrower across by the
// cosine.
TEST(ReflectionLobe, OfASmoothSurfaceHasTheWidthsOfItsHalfVectors) {
  for (const double cosine : {0.4, 0.7, 0.95}) {
    const ReflectionLobe lobe = reflectionLobeOf(0.01, cosine);
    EXPECT_NEAR(lobe.along, 0.02, 2e-4);
    EXPECT_NEAR(lobe.across, 0.02 * cosine, 2e-4);
    EXPECT_NEAR(lobe.tilt, 0, 1e-3);
  }
}

}  // namespace
}  // namespace opaline
