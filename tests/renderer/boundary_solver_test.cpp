// How boundary transport's equation is solved: to the tolerance, in few steps, and closer to a fine
// solution the finer the division.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "opaline/media.h"
#include "renderer/boundary_fixture.h"
#include "renderer/scene/division.h"
#include "scene/mesh/merged_mesh.h"

namespace opaline {
namespace {

using namespace test;

using BoundarySolverTest = RendererTest;

float worstOf(const Solution& solution) {
  return std::max({solution.residual[0], solution.residual[1], solution.residual[2]});
}

Scene litBowl(const Medium& medium) {
  Scene scene = sceneOf(Bowl{10}.mesh(), medium, {10, 5, 40}, 10.5F);
  scene.lighting.directional = {{toVec3(unit({0.3, 0.5, 0.8})), {3, 3, 3}}};
  return scene;
}

// For any body, medium and tolerance: bright and dark ones, twisted ones, a plate.
TEST_F(BoundarySolverTest, ResidualIsAsSmallAsAsked) {
  Scene twisted = backlitBear(50, marble());
  twisted.deformers = {{DeformerKind::Twist, 2, 0}, {DeformerKind::Bend, 1, 0}};
  Scene plate = sceneOf(box({0, 0, 0}, {10, 10, 0.5F}, 20), marble(), {0, 10, 40}, 15);
  plate.lighting.directional = {{{0, 0, -1}, {1, 1, 1}}};
  for (const Scene& scene : {litBowl(marble()), litBowl(skin()), twisted, plate}) {
    renderer().setScene(scene);
    int steps = 0;
    for (const float tolerance : {0.1F, 0.003F}) {
      RenderOptions options = boundaryOptions(16, 2);
      options.tolerance = tolerance;
      options.site = Site::Vertex;
      const RenderReport report = renderer().render(options, {Aov::Exitance}).report;
      ASSERT_EQ(report.solutions.size(), 3U);
      EXPECT_EQ(report.transport, Transport::Boundary);
      EXPECT_GT(report.clusters, 500U);
      for (const Solution& solution : report.solutions) {
        EXPECT_LE(worstOf(solution), tolerance) << scene.name << " " << tolerance;
        EXPECT_LE(solution.steps, 8);
      }
      EXPECT_GE(report.solutions[0].steps, 1);
      EXPECT_GE(report.solutions[0].steps, steps);
      steps = report.solutions[0].steps;
    }
  }
}

// A body of few clusters is solved in as many steps, or in one more. A very small body hardly
// scatters light within itself, which leaves the basis not quite orthogonal. The rest is rounding,
// which single precision cannot reduce to a residual of 0.
TEST_F(BoundarySolverTest, NoResidualIsSmallerThanRounding) {
  for (const float edge : {0.03F, 0.05F, 0.1F}) {
    Scene scene = sceneOf(box({0, 0, 0}, {edge, edge, edge}, 1), marble(), {0, 0, 1}, edge);
    scene.lighting.ambient = {1, 1, 1};
    renderer().setScene(scene);
    RenderOptions options = boundaryOptions(16);
    options.tolerance = 1e-4F;
    const RenderReport report = renderer().render(options, {Aov::Exitance}).report;
    ASSERT_LT(report.clusters, 8U);
    ASSERT_EQ(report.solutions.size(), 1U);
    EXPECT_LE(report.solutions[0].steps, static_cast<int>(report.clusters) + 1);
    for (const float residual : report.solutions[0].residual) {
      EXPECT_GT(residual, 0) << edge;
      EXPECT_LT(residual, 1e-3) << edge;
    }
  }
}

// A plate a hundredth as thick as wide asks for thousands of clusters. The note must give the
// number.
TEST_F(BoundarySolverTest, TooFewUnknownsForAThinBodyAreNoted) {
  std::vector<std::string> notes;
  RendererOptions rendererOptions = sharedRenderer().options();
  rendererOptions.log = [&](LogLevel level, std::string_view message) {
    if (level == LogLevel::Note && message.find("clusters") != std::string_view::npos)
      notes.emplace_back(message);
  };
  Renderer fresh(rendererOptions);
  fresh.setScene(sceneOf(box({0, 0, 0}, {10, 10, 0.1F}, 4), marble(), {0, 10, 40}, 15));
  const auto clustersWithin = [&](int budget) {
    RenderOptions options = boundaryOptions(16);
    options.maxClusters = budget;
    notes.clear();
    return fresh.render(options, {Aov::Exitance}).report.clusters;
  };
  EXPECT_GT(clustersWithin(64), 60U);
  ASSERT_EQ(notes.size(), 1U);
  const std::string option = "RenderOptions::maxClusters to ";
  ASSERT_NE(notes[0].find(option), std::string::npos) << notes[0];
  const int enough = std::stoi(notes[0].substr(notes[0].find(option) + option.size()));
  EXPECT_EQ(clustersWithin(enough), static_cast<std::size_t>(enough));
  EXPECT_TRUE(notes.empty());
  EXPECT_EQ(clustersWithin(262'144), static_cast<std::size_t>(enough));
}

// Nothing is solved on the floor, so the body beside it keeps as many clusters as it has alone.
TEST(Division, AnOpenFloorTakesNoClustersFromABody) {
  Scene scene = sceneOf(box({0, 0, 0}, {5, 5, 5}, 4), marble(), {0, 10, 40}, 15);
  const auto clusters = [&](const std::vector<bool>& hasInside) {
    const Insides insides{hasInside, std::vector<bool>(hasInside.size(), false)};
    const scene::MergedMesh merged = scene::mergedMesh(scene);
    return *divide(merged, divisionFor(scene, merged, insides, 1'000'000, 9000)).clusters;
  };
  const auto alone = clusters({true});
  scene.objects.push_back(scene.objects.front());
  scene.objects.back().mesh = sheet({0, -5, 0}, {0, 0, 70}, {70, 0, 0}, 4);
  const auto beside = clusters({true, false});
  EXPECT_EQ(beside.firstOfObject[1], alone.firstOfObject[1]);
  EXPECT_EQ(beside.coarseness(), 1);
  // As fine as the medium asks, there would be too many.
  EXPECT_GT(clusters({true, true}).coarseness(), 1);
}

TEST_F(BoundarySolverTest, ErrorFallsWithTheTolerance) {
  renderer().setScene(litBowl(marble()));
  const auto picture = [&](float tolerance) {
    RenderOptions options = boundaryOptions(40, 2);
    options.tolerance = tolerance;
    return render(options, {Aov::Exitance})[0];
  };
  const Image fine = picture(3e-4F);
  double last = 1;
  for (const float tolerance : {0.1F, 0.03F, 0.01F, 0.003F}) {
    const double rms = errorsOf(picture(tolerance), fine).rms;
    EXPECT_LT(rms, static_cast<double>(tolerance)) << tolerance;
    EXPECT_LT(rms, last) << tolerance;
    last = rms;
  }
}

// In nodes with both sides of a plate the areas cancel, but not the moments.
TEST_F(BoundarySolverTest, NodesOfBothSidesOfAPlateCount) {
  Scene plate = sceneOf(box({0, 0, 0}, {10, 10, 0.5F}, 20), skin(), {0, 0, -40}, 6);
  plate.lighting.directional = {{{0, 0, 1}, {1, 1, 1}}};
  renderer().setScene(plate);
  RenderOptions options = boundaryOptions(24);
  const Image usual = render(options, {Aov::Exitance})[0];
  options.tolerance = 3e-4F;
  const Image fine = render(options, {Aov::Exitance})[0];
  EXPECT_LT(errorsOf(usual, fine).rms, 0.015);
}

TEST_F(BoundarySolverTest, NoMoreUnknownsThanAllowed) {
  renderer().setScene(litBowl(marble()));
  RenderOptions options = boundaryOptions(40);
  const RenderResult usual = renderer().render(options, {Aov::Exitance});
  options.maxClusters = 600;
  const RenderResult few = renderer().render(options, {Aov::Exitance});
  EXPECT_LE(few.report.clusters, 600U);
  EXPECT_GT(few.report.clusters, 200U);
  EXPECT_GT(usual.report.clusters, 2 * few.report.clusters);
  EXPECT_LT(errorsOf(few.images[0], usual.images[0]).rms, 0.1);
}

// In a body a few mean free paths wide all points of light are near all clusters. That makes the
// largest possible number of pairs, more than a shader's loop may have rounds on a software device.
TEST_F(BoundarySolverTest, ManyUnknownsInASmallBodySayWhatFewDo) {
  Scene bear = backlitBear(8, findMedium("gummy-red").value());
  bear.lighting = {};
  bear.lighting.ambient = {1, 1, 1};
  renderer().setScene(bear);
  RenderOptions options = boundaryOptions(32);
  options.maxSurfels = 65'536;
  const RenderResult many = renderer().render(options, {Aov::Exitance});
  options.maxClusters = 2048;
  const RenderResult few = renderer().render(options, {Aov::Exitance});
  EXPECT_GT(many.report.clusters, 3000U);
  EXPECT_LE(few.report.clusters, 2048U);
  EXPECT_LT(errorsOf(few.images[0], many.images[0]).rms, 0.04);
}

TEST_F(BoundarySolverTest, OneSolutionAndOneMoreForEachBounce) {
  renderer().setScene(litBowl(marble()));
  for (const int bounces : {0, 1, 4}) {
    const RenderReport report =
        renderer().render(boundaryOptions(16, bounces), {Aov::Exitance}).report;
    EXPECT_EQ(report.solutions.size(), static_cast<std::size_t>(bounces) + 1);
  }
  RenderOptions options = boundaryOptions(16);
  options.transport = Transport::BetterDipole;
  EXPECT_TRUE(renderer().render(options, {Aov::Exitance}).report.solutions.empty());
}

}  // namespace
}  // namespace opaline
