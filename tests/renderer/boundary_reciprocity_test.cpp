// Helmholtz's reciprocity: as much light goes from one direction to another as the other way round.
// A distant picture of a body lit evenly from afar adds this up: light enters in proportion to F_t
// μ, and leaves likewise. The solution does not know of this law: its sources are points inside,
// and its result is the fluence on the surface. The bodies are round, since slanting light starts
// nearer to the surface but leaves as if it had come from all depths. The docs say how far off flat
// bodies are.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>

#include "renderer/boundary_fixture.h"

namespace opaline {
namespace {

using namespace test;

/// Little, some and much absorption.
Medium mixed() {
  return {"mixed", {1.5, 1.2, 1}, {0.002, 0.03, 0.2}, 1.4};
}

struct ReciprocityCase {
  const char* name;
  int bounces;
  Vector a;
  Vector b;
};

void PrintTo(const ReciprocityCase& directions, std::ostream* to) {
  *to << directions.name;
}

/// The flux that leaves towards `eye` in light from `lamp`, up to a factor. Parts appear in the
/// picture at their size as seen from there.
std::array<double, 3> fluxTowards(const Mesh& mesh, const Vector& eye, const Vector& lamp,
                                  int bounces) {
  constexpr double reachMm = 12;
  constexpr double distanceMm = 50 * reachMm;
  Scene scene = sceneOf(mesh, mixed(), toVec3(distanceMm * unit(eye)), reachMm);
  scene.camera.up = std::abs(unit(eye)[1]) > 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  scene.lighting.directional = {{toVec3(unit(lamp)), {1, 1, 1}}};
  RenderOptions options = boundaryOptions(96, bounces);
  options.specular = false;
  options.antialias = 4;
  options.maxSurfels = 65'536;
  const Image radiance = renderBoundary(scene, options, {Aov::Radiance}).images[0];
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < radiance.rgba.size(); ++i)
    if (i % 4 != 3) sum[i % 4] += static_cast<double>(radiance.rgba[i]);
  return sum;
}

class BoundaryReciprocityTest : public RendererTestBase<testing::TestWithParam<ReciprocityCase>> {};

TEST_P(BoundaryReciprocityTest, LampAndEyeMayChangePlaces) {
  const auto& [name, bounces, a, b] = GetParam();
  // In blue much light leaves after one collision. It entered at a slant but is shown as leaving
  // evenly. That light alone is 8 % off on the bowl, all other light 3 %.
  constexpr std::array<double, 3> most{0.015, 0.025, 0.055};
  const std::array<Mesh, 2> bodies{peanut(20), Bowl{10}.mesh()};
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    const std::array<double, 3> there = fluxTowards(bodies[body], a, b, bounces);
    const std::array<double, 3> back = fluxTowards(bodies[body], b, a, bounces);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(back[c] / there[c], 1, most[c]) << (body == 0 ? "peanut " : "bowl ") << c;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Directions, BoundaryReciprocityTest,
    testing::Values(ReciprocityCase{"beside", 0, {0, 0.2, 1}, {0.9, 0.1, 0.5}},
                    ReciprocityCase{"behind", 0, {0.1, 0.2, 1}, {0.5, 0.6, -0.8}},
                    ReciprocityCase{"beside_with_bounces", 2, {0, 0.2, 1}, {0.9, 0.1, 0.5}}),
    [](const auto& directions) { return std::string(directions.param.name); });

}  // namespace
}  // namespace opaline
