// The division of the surface into pieces with known E.

#include <gtest/gtest.h>

#include <cmath>

#include "reference/bodies.h"
#include "reference/irradiance.h"
#include "reference/patches.h"
#include "reference/source_tree.h"

namespace opaline {
namespace {

using namespace test;
using reference::Patches;

TEST(TriangleRuleTest, IntegratesPolynomialsOfDegreeFour) {
  // ∫ u^i v^j over the unit triangle is i! j!/(i + j + 2)!; its area is 1/2.
  const auto factorial = [](int n) { return std::tgamma(n + 1.0); };
  for (int i = 0; i <= 4; ++i) {
    for (int j = 0; i + j <= 4; ++j) {
      double sum = 0;
      for (const auto& point : reference::triangleRule()) {
        sum += 0.5 * point.part * std::pow(point.weights[1], i) * std::pow(point.weights[2], j);
      }
      EXPECT_NEAR(sum, factorial(i) * factorial(j) / factorial(i + j + 2), 1e-14) << i << " " << j;
    }
  }
}

TEST(QuadraticTest, GoesThroughItsValuesAndIsExactForQuadratics) {
  const auto quadratic = [](double u, double v) {
    return reference::Colour{1 + 2 * u - 3 * v + u * v, u * u - 4 * v * v, 7};
  };
  std::array<reference::Colour, 6> values;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& weights = reference::triangleRule()[i].weights;
    values[i] = quadratic(weights[1], weights[2]);
  }
  const reference::QuadraticE found(values);
  for (const auto& [u, v] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.3, 0.6}}) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found.at(u, v)[c], quadratic(u, v)[c], 1e-12);
  }
}

/// A sheet of 20 mm in the sun, with the round shadow of a ball in its middle.
reference::Scene shadowed(double radius) {
  auto scene = sceneOfBodies({bodyOf(sheet({0, 0, 0}, {10, 0, 0}, {0, 10, 0}, 5)),
                              bodyOf(sphere({0, 0, 20}, static_cast<float>(radius), 5))});
  scene.lighting.directional = {{{0, 0, 1}, {1, 2, 0}}};
  return scene;
}

double fluxOf(const Patches& patches) {
  double flux = 0;
  for (const auto& moments : patches.moments) flux += moments.channels[0].flux;
  return flux;
}

TEST(PatchesTest, FluxIsThatOfTheLitSurface) {
  const auto scene = shadowed(3);
  const reference::Geometry geometry(scene);
  const reference::Irradiance irradiance(geometry);
  const auto patches = makePatches(geometry, irradiance, 0, {1e-3, 1, 0.02});
  ASSERT_TRUE(patches);
  const double entering = fresnelTransmittance(1.5, 1);
  EXPECT_NEAR(fluxOf(*patches) / (entering * (400 - std::numbers::pi * 9)), 1, 1e-4);
  // Only the border is refined: about 2πr/0.02 edges, and 400 mm² of coarse squares.
  EXPECT_GT(patches->withBorders, 900U);
  EXPECT_LT(patches->size(), 9000U);
  for (const auto& moments : patches->moments) {
    EXPECT_EQ(moments.channels[2].flux, 0);
    EXPECT_NEAR(moments.channels[1].flux, 2 * moments.channels[0].flux, 1e-12);
  }
}

TEST(PatchesTest, SmoothLightOverSmallTrianglesNeedsNoMore) {
  auto scene = sceneOfBodies({bodyOf(sphere({0, 0, 0}, 5, 4))});
  scene.lighting.ambient = {1, 1, 1};
  const reference::Geometry geometry(scene);
  const reference::Irradiance irradiance(geometry);
  // The first only looks more closely, and then undoes the division.
  for (const double largest : {0.1, 10.0}) {
    const auto patches = makePatches(geometry, irradiance, 0, {1e-3, largest, 0.01});
    ASSERT_TRUE(patches);
    EXPECT_EQ(patches->size(), scene.bodies[0].triangles.size());
    EXPECT_EQ(patches->withBorders, 0U);
  }
}

TEST(PatchesTest, TooManyAreNone) {
  const auto scene = shadowed(3);
  const reference::Geometry geometry(scene);
  const reference::Irradiance irradiance(geometry);
  reference::PatchOptions options{1e-3, 1, 0.02};
  options.most = 100;
  EXPECT_FALSE(makePatches(geometry, irradiance, 0, options));
}

TEST(SourceTreeTest, HoldsEachPatchOnceInsideTheBallsAbove) {
  const auto scene = shadowed(3);
  const reference::Geometry geometry(scene);
  const reference::Irradiance irradiance(geometry);
  auto patches = makePatches(geometry, irradiance, 0, {1e-3, 1, 0.3});
  ASSERT_TRUE(patches);
  const double flux = fluxOf(*patches);
  const reference::SourceTree tree(*std::move(patches));
  EXPECT_NEAR(tree.node(0).moments.channels[0].flux / flux, 1, 1e-12);
  std::vector<int> seen(tree.patchCount());
  std::vector<std::uint32_t> waiting{0};
  while (!waiting.empty()) {
    const auto& node = tree.node(waiting.back());
    waiting.pop_back();
    if (node.count == 0) ++seen[node.first];
    for (std::uint32_t i = 0; i < node.count; ++i) {
      const auto& child = tree.node(node.first + i);
      EXPECT_LE(length(child.moments.centre - node.moments.centre) + child.moments.radiusMm,
                node.moments.radiusMm * (1 + 1e-12));
      waiting.push_back(node.first + i);
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<long>(seen.size()));
}

}  // namespace
}  // namespace opaline
