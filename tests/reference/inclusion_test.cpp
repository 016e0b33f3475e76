// Opaque bodies inside media in path tracing: where hardly anything scatters, geometry tells how
// much light they absorb.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "reference/bodies.h"
#include "reference/path/walk.h"

namespace opaline::reference {
namespace {

using test::sphere;

// Of parallel light on a ball, the part a²/R² hits the core, which absorbs all but its share.
// Nothing between medium and core mirrors light, whatever the core's index of refraction.
TEST(InclusionTest, ACoreTakesTheLightThatMeetsIt) {
  constexpr double ballMm = 10;
  constexpr double coreMm = 6;
  constexpr int particles = 10'000;
  OpaqueMaterial metal;
  metal.baseColor = {0.3F, 0.3F, 0.3F};
  metal.metallic = 1;
  OpaqueMaterial black;
  black.baseColor = {0, 0, 0};
  black.metallic = 0;
  OpaqueMaterial grey = black;
  grey.baseColor = {0.6F, 0.6F, 0.6F};
  OpaqueMaterial half = grey;
  half.metallic = 0.5F;
  for (const auto& [material, share] : std::vector<std::pair<OpaqueMaterial, double>>{
           {black, 0}, {grey, 0.6}, {metal, 0.3}, {half, 0.6}}) {
    Body core = test::bodyOf(sphere({0, 0, 0}, coreMm, 3));
    core.opaque = material;
    const Scene scene = test::sceneOfBodies({test::bodyOf(sphere({0, 0, 0}, ballMm, 3)), core});
    const Geometry geometry(scene);
    const DistanceBound bound(scene);
    const std::vector<Interior> interiors{{.sigmaTPerMm = 1e-7, .albedo = 1, .eta = 1.0001}, {}};
    const Walk walk(geometry, bound, interiors, 0);
    int left = 0;
    for (int i = 0; i < particles; ++i) {
      Random random(3, static_cast<std::uint64_t>(i));
      const double radius = 0.999 * ballMm * std::sqrt(random());
      const double angle = 2 * std::numbers::pi * random();
      const Vector from{radius * std::cos(angle), radius * std::sin(angle), 20};
      walk.follow({from, {0, 0, -1}}, random, [&](const Leaving&) { ++left; });
    }
    const double met = std::pow(coreMm / (0.999 * ballMm), 2);
    EXPECT_NEAR(static_cast<double>(left) / particles, 1 - met * (1 - share), 0.015) << share;
  }
}

}  // namespace
}  // namespace opaline::reference
