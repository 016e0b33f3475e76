// Bodies of parts that reach into each other.

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "opaline/media.h"
#include "renderer/boundary_fixture.h"

namespace opaline {
namespace {

using namespace test;

using BoundaryOverlapTest = RendererTest;

constexpr double eachRadiusMm = 10;
constexpr double besideMm = 5;  // of each ball's middle

Mesh ballAt(double y, int levels = 4) {
  return sphere({0, static_cast<float>(y), 0}, eachRadiusMm, levels);
}

Mesh ballsApart(double y) {
  return together(ballAt(-besideMm), ballAt(besideMm + y));
}

// The surface of both balls from without, seen from the place in the middle of both.
Mesh unionOfBalls() {
  return starShaped(
      [](const Vector& d) {
        return std::abs(d[1]) * besideMm +
               std::sqrt(eachRadiusMm * eachRadiusMm - besideMm * besideMm * (1 - d[1] * d[1]));
      },
      5);
}

Scene litFromBehind(const Mesh& mesh) {
  Scene scene = sceneOf(mesh, *findMedium("skimmilk"), {0, 0, 60}, 20);
  scene.lighting.directional = {{toVec3(unit({0.45, 0.35, -0.82})), {3, 3, 3}}};
  return scene;
}

RenderOptions optionsOfBalls() {
  RenderOptions options = boundaryOptions(64, 2);
  options.maxSurfels = 65'536;
  return options;
}

// Root mean square of the difference over the mean of `expected`, by channel, over what both show.
std::array<double, 3> differenceOf(const Image& image, const Image& expected) {
  std::array<double, 3> squares{};
  std::array<double, 3> sum{};
  int count = 0;
  forEachCovered(expected, [&](std::size_t i) {
    if (image.rgba[i + 3] == 0) return;
    ++count;
    for (std::size_t c = 0; c < 3; ++c) {
      const double value{expected.rgba[i + c]};
      squares[c] += std::pow(static_cast<double>(image.rgba[i + c]) - value, 2);
      sum[c] += value;
    }
  });
  EXPECT_GT(count, 1000);
  for (std::size_t c = 0; c < 3; ++c) squares[c] = std::sqrt(squares[c] * count) / sum[c];
  return squares;
}

// Before, each ball's cap within the other one took light away: 30 to 40 % in the whole picture.
TEST_F(BoundaryOverlapTest, BallsAreAsBrightAsTheirUnion) {
  const Image parts =
      renderBoundary(litFromBehind(ballsApart(0)), optionsOfBalls(), {Aov::Exitance}).images[0];
  const Image whole =
      renderBoundary(litFromBehind(unionOfBalls()), optionsOfBalls(), {Aov::Exitance}).images[0];
  for (const double difference : differenceOf(parts, whole)) EXPECT_LT(difference, 0.05);
}

// What was within the other ball comes to light if a program moves the balls apart.
TEST_F(BoundaryOverlapTest, PositionsMayMovePartsApart) {
  constexpr double moveMm = 14;
  const std::vector<Aov> aovs{Aov::Exitance, Aov::Position};
  const auto wasWithin = [](const Vector& at) {
    const bool ofUpper = at[1] > moveMm / 2;
    return length(at - Vector{0, ofUpper ? moveMm - besideMm : besideMm, 0}) < eachRadiusMm - 1;
  };
  const Mesh apart = ballsApart(moveMm);
  const std::vector<Image> expected =
      renderBoundary(litFromBehind(apart), optionsOfBalls(), aovs).images;
  const std::vector<Image> before =
      renderBoundary(litFromBehind(ballsApart(0)), optionsOfBalls(), aovs).images;
  Renderer& renderer = *sharedRenderer().renderer;
  renderer.replacePositions(0, apart.positionsMm);
  const std::vector<Image> moved = renderer.render(optionsOfBalls(), aovs).images;
  const std::array<double, 3> light = meanWhere(moved[0], moved[1], wasWithin);
  const std::array<double, 3> right = meanWhere(expected[0], expected[1], wasWithin);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(light[c], right[c], 0.05 * right[c]) << c;
  renderer.restorePositions(0);
  EXPECT_EQ(renderer.render(optionsOfBalls(), aovs).images[0].rgba, before[0].rgba);
}

// Half-spaces are summed over all surfaces, boundary transport over those that bound the body. A
// renderer that does one must not keep the other's surfels.
TEST_F(BoundaryOverlapTest, EachTransportHasItsOwnSurfaces) {
  Scene scene = litFromBehind(ballsApart(0));
  scene.lighting.ambient = {.3F, .3F, .3F};
  RenderOptions boundary = optionsOfBalls();
  boundary.bounces = 0;
  boundary.maxSurfels = 8192;
  RenderOptions dipole = boundary;
  dipole.transport = Transport::Dipole;
  RenderOptions occluded = dipole;
  occluded.ambientOcclusion = true;  // makes clusters too
  RenderOptions pattern = occluded;
  pattern.sum = Sum::Pattern;
  const std::vector<RenderOptions> all{dipole, occluded, boundary, pattern};
  std::vector<Image> alone;
  for (const RenderOptions& options : all)
    alone.push_back(renderBoundary(scene, options, {Aov::Exitance}).images[0]);
  Renderer& renderer = *sharedRenderer().renderer;
  for (const std::size_t i : {0U, 2U, 1U, 0U, 2U, 3U, 1U, 2U, 0U})
    EXPECT_EQ(renderer.render(all[i], {Aov::Exitance}).images[0].rgba, alone[i].rgba) << i;
  View first(renderer, boundary);
  View second(renderer, dipole);
  for (int i = 0; i < 2; ++i) {
    const FrameOrder order{.aovs = {Aov::Exitance}, .reuseLight = true};
    EXPECT_EQ(first.render(order).images[0].rgba, alone[2].rgba) << i;
    EXPECT_EQ(second.render(order).images[0].rgba, alone[0].rgba) << i;
  }
}

}  // namespace
}  // namespace opaline
