// Bodies of several media. In path tracing a place inside has the medium of the nearest surface.
// Boundary transport uses the mean of the media at both ends of a path.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "reference/bodies.h"
#include "reference/integral.h"
#include "reference/path/path_tracer.h"
#include "reference/path/walk.h"
#include "reference/posed_scene.h"
#include "reference/truth.h"
#include "renderer/renderer_fixture.h"

namespace opaline {
namespace {

using namespace test;

constexpr float radiusMm = 6;

Medium white() {
  return {"white", {2, 2, 2}, {0.002, 0.002, 0.002}, 1.3};
}
Medium darker() {
  return {"darker", {2, 2, 2}, {0.002, 0.02, 0.1}, 1.3};
}

/// A ball around the origin, seen from +z, with one medium in the upper half and another in the
/// lower.
Scene ballOfTwo(const Medium& upper, const Medium& lower) {
  const auto [above, below] = halvesOf(sphere({0, 0, 0}, radiusMm, 4), {0, 1, 0});
  Scene scene = test::sceneOf(above, upper, {0, 0, 40}, 1.02F * radiusMm);
  scene.objects.push_back({"lower", below, lower});
  scene.lighting.directional = {{{0.48F, 0.36F, 0.8F}, {1, 1, 1}}};
  return scene;
}

Scene ballOfOne(const Medium& medium) {
  Scene scene = ballOfTwo(medium, medium);
  scene.objects = {{"ball", sphere({0, 0, 0}, radiusMm, 4), medium}};
  return scene;
}

constexpr std::size_t bands = 6;
using Bands = std::array<std::array<double, 3>, bands>;

/// Means over bands of the height, from below to above.
Bands meansOf(const Image& exitance, const Image& position) {
  Bands sums{};
  std::array<double, bands> covered{};
  for (std::size_t i = 0; i < exitance.rgba.size(); i += 4) {
    if (position.rgba[i + 3] == 0) continue;
    const double share = (double{position.rgba[i + 1]} / double{radiusMm} + 1) / 2;
    const auto band = static_cast<std::size_t>(std::clamp(share, 0.0, 0.999) * bands);
    covered[band] += 1;
    for (std::size_t c = 0; c < 3; ++c) sums[band][c] += double{exitance.rgba[i + c]};
  }
  for (std::size_t band = 0; band < bands; ++band)
    for (double& sum : sums[band]) sum /= covered[band];
  return sums;
}

class SeveralMediaTest : public RendererTest {
 protected:
  static constexpr int edge = 48;

  static RenderOptions options(Transport transport) {
    RenderOptions options;
    options.width = options.height = edge;
    options.transport = transport;
    options.bounces = 0;
    options.maxSurfels = 16'384;
    return options;
  }

  static Image positionsOf(const Scene& scene) {
    return render(scene, options(Transport::Dipole), {Aov::Position})[0];
  }
};

void expectNear(const Bands& found, const Bands& expected, const std::array<double, 3>& most) {
  for (std::size_t band = 0; band < bands; ++band)
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(found[band][c] / expected[band][c], 1, most[c]) << band << " " << c;
}

// Beer and Lambert: with two black media that hardly refract, a beam along the axis passes equal
// lengths of both, wherever it hits the ball.
TEST(SeveralMediaWalkTest, LightPassesTheMediumOfTheNearestSurface) {
  constexpr int particles = 40'000;
  const std::array<double, 2> sigmaPerMm{0.02, 0.3};
  const Scene ball = ballOfTwo(white(), darker());
  EXPECT_THROW(reference::posedScene(ball, {.seconds = 2, .clip = 7}, {}), UsageError);
  EXPECT_THROW(reference::posedScene(ball, {.seconds = -1}, {}), UsageError);
  const reference::Scene scene = reference::posedScene(ball, {}, {});
  const reference::Geometry geometry(scene);
  const reference::DistanceBound bound(scene);
  std::vector<reference::Interior> interiors;
  for (const double sigma : sigmaPerMm)
    interiors.push_back({.sigmaTPerMm = sigma, .albedo = 0, .eta = 1.0001});
  const reference::Walk walk(geometry, bound, interiors, 0);
  int left = 0;
  for (int i = 0; i < particles; ++i) {
    reference::Random random(3, static_cast<std::uint64_t>(i));
    const double distance = 0.999 * double{radiusMm} * std::sqrt(random());
    const double angle = 2 * std::numbers::pi * random();
    const Vector from{distance * std::cos(angle), 20, distance * std::sin(angle)};
    walk.follow({from, {0, -1, 0}}, random, [&](const reference::Leaving&) { ++left; });
  }
  // Over the beam's cross-section, with path lengths 2R x: 2 ∫ x e^{-tx} dx from 0 to 1.
  const double t = (sigmaPerMm[0] + sigmaPerMm[1]) * double{radiusMm};
  const double expected = 2 * (1 - std::exp(-t) * (1 + t)) / (t * t);
  EXPECT_NEAR(static_cast<double>(left) / particles, expected, 0.01 * expected + 0.004);
}

// Two objects of one medium form the same body as a single object, with any transport.
TEST_F(SeveralMediaTest, ObjectsOfOneMediumAreOneBody) {
  for (const Transport transport : {Transport::Dipole, Transport::Boundary}) {
    const Image position = positionsOf(ballOfOne(darker()));
    const Image one = render(ballOfOne(darker()), options(transport), {Aov::Exitance})[0];
    const Image two = render(ballOfTwo(darker(), darker()), options(transport), {Aov::Exitance})[0];
    expectNear(meansOf(two, position), meansOf(one, position), {0.01, 0.01, 0.01});
  }
}

TEST_F(SeveralMediaTest, PathTracingAgrees) {
  const Scene scene = ballOfTwo(white(), darker());
  const Image position = positionsOf(scene);
  const Image found = render(scene, options(Transport::Boundary), {Aov::Exitance})[0];
  const reference::Scene posed = reference::posedScene(scene, {}, {});
  const reference::Geometry geometry(posed);
  const reference::Irradiance irradiance(geometry);
  reference::PathTracer tracer(geometry, {.bounces = 0, .cellMm = 1.5});
  tracer.run(40'000);
  reference::PictureOptions picture;
  picture.width = picture.height = edge;
  picture.aov = Aov::Exitance;
  const Image truth = pathTruth(tracer, geometry, irradiance, picture).image;
  expectNear(meansOf(found, position), meansOf(truth, position), {0.03, 0.08, 0.18});
}

// The integral covers the whole body, with the medium of the place in question.
TEST_F(SeveralMediaTest, TheIntegralAgrees) {
  const Scene scene = ballOfTwo(white(), darker());
  const Image position = positionsOf(scene);
  RenderOptions how = options(Transport::Dipole);
  how.site = Site::Fragment;
  const Image found = render(scene, how, {Aov::Exitance})[0];
  const reference::Scene posed = reference::posedScene(scene, {}, {});
  const reference::Geometry geometry(posed);
  const reference::Irradiance irradiance(geometry);
  reference::PictureOptions picture;
  picture.width = picture.height = edge;
  picture.aov = Aov::Exitance;
  const Image truth =
      integralTruth(geometry, irradiance, {.tolerance = 0.01}, picture, {}).picture.image;
  expectNear(meansOf(found, position), meansOf(truth, position), {0.01, 0.01, 0.01});
}

}  // namespace
}  // namespace opaline
