// The tree of surfels against the sum of all of them: what it takes for the whole of a node stays
// within the tolerance, where a node is near, a place dark or lights are coloured.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "bssrdf/fresnel.h"
#include "bssrdf/profile.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"
#include "renderer/sums.h"

namespace opaline {
namespace {

using namespace test;

using TreeTest = RendererTest;

RenderOptions treeOptions(int edge, Site site = Site::Fragment) {
  RenderOptions options = smallOptions();
  options.width = options.height = edge;
  options.site = site;
  return options;
}

/// A ball before another, of one body.
Scene twoBalls() {
  Scene scene = sceneOf(together(sphere({-1, 0, 14}, 3, 4), sphere({2, 1, -10}, 6, 4)), skin(),
                        {0, 0, 60}, 9);
  scene.lighting.directional = {{toVec3(unit({1, 0.5, 0.2})), {3, 3, 3}},
                                {toVec3(unit({-1, 0.2, -0.6})), {1, 1, 1}}};
  return scene;
}

using TreeCase = std::tuple<Transport, Site>;

class TreeToleranceTest : public RendererTestBase<testing::TestWithParam<TreeCase>> {};

TEST_P(TreeToleranceTest, ErrorFallsWithItWhileWorkGrows) {
  const auto [transport, site] = GetParam();
  // All sources at all of the bear's vertices would take long.
  renderer().setScene(site == Site::Fragment ? backlitBear(25, marble()) : twoBalls());
  RenderOptions options = treeOptions(40, site);
  options.transport = transport;
  options.sum = Sum::All;
  const Image exact = render(options, {Aov::Exitance})[0];
  options.sum = Sum::Tree;
  double lastRms = 1;
  double lastEvaluations = 0;
  for (const float tolerance : {0.1F, 0.03F, 0.01F, 0.003F}) {
    options.tolerance = tolerance;
    const std::vector<Image> images = render(options, {Aov::Exitance, Aov::Evaluations});
    const SumErrors errors = errorsOf(images[0], exact);
    const double evaluations = meanOf(images[1])[0];
    EXPECT_GT(errors.pixels, 300);
    EXPECT_LT(errors.rms, static_cast<double>(tolerance));
    EXPECT_LT(errors.localLargest, static_cast<double>(tolerance));
    EXPECT_LT(errors.rms, lastRms) << tolerance;
    EXPECT_GT(evaluations, lastEvaluations) << tolerance;
    EXPECT_LT(evaluations, 2000);  // of some 150,000 sources
    forEachCovered(images[1], [&](std::size_t i) { ASSERT_GE(images[1].rgba[i], 1); });
    lastRms = errors.rms;
    lastEvaluations = evaluations;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Sums, TreeToleranceTest,
    testing::Combine(testing::Values(Transport::Dipole, Transport::BetterDipole),
                     testing::Values(Site::Fragment, Site::Vertex)),
    [](const testing::TestParamInfo<TreeCase>& treeCase) {
      return std::string(std::get<0>(treeCase.param) == Transport::Dipole ? "Dipole"
                                                                          : "BetterDipole") +
             (std::get<1>(treeCase.param) == Site::Vertex ? "Vertex" : "Fragment");
    });

void expectWithin(double tolerance, const SumErrors& errors, const char* what) {
  EXPECT_LT(errors.localLargest, tolerance) << what;
}

// A long bar has long nodes: a place may lie far from the middle of one and yet beside its end.
// Accepted by the distance of their middles alone, such nodes made errors of 110 %.
TEST_F(TreeTest, BigNodesNearbyAreOpened) {
  Scene scene = sceneOf(box({0, 0, 0}, {20, 0.8F, 0.8F}, 24), marble(), {0, 10, 60}, 21);
  scene.lighting.directional = {{toVec3(unit({0.2, 1, 0.1})), {3, 3, 3}}};
  scene.lighting.points = {{{5, 3, 0}, {40, 40, 40}}};
  renderer().setScene(scene);
  for (const float tolerance : {0.1F, 0.01F}) {
    RenderOptions options = treeOptions(96);
    options.tolerance = tolerance;
    const TreeAndAll images = treeAndAll(options);
    expectWithin(static_cast<double>(tolerance), errorsOf(images.tree, images.all), "bar");
  }
}

// Where one ball ends before the other, a tile of the picture has places far from each other, and
// what is far from one is near the other.
TEST_F(TreeTest, SilhouettesAreAsGoodAsTheRest) {
  renderer().setScene(twoBalls());
  RenderOptions options = treeOptions(96);
  options.sum = Sum::Tree;
  const TreeAndAll images = treeAndAll(options);
  const Image depth = render(options, {Aov::Depth})[0];
  // Beside a pixel that lies 5 mm nearer or further.
  int silhouette = 0;
  const auto atSilhouette = [&](std::size_t index) {
    const int x = static_cast<int>(index / 4) % depth.width;
    const int y = static_cast<int>(index / 4) / depth.width;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, depth.height - 1); ++v)
      for (int u = std::max(x - 1, 0); u <= std::min(x + 1, depth.width - 1); ++u)
        if (depth.pixel(u, v)[3] > 0 && std::abs(depth.pixel(u, v)[0] - depth.rgba[index]) > 5)
          return ++silhouette > 0;
    return false;
  };
  expectWithin(0.01, errorsWhere(images.tree, images.all, atSilhouette), "silhouette");
  EXPECT_GT(silhouette, 50);
  expectWithin(0.01, errorsOf(images.tree, images.all), "two balls");
}

// The far end of a bar lit at the other: down to a ten-thousandth of the brightest place the
// tolerance is of what is there, not of the picture.
TEST_F(TreeTest, DarkPlacesAreAsGoodAsBrightOnes) {
  Scene scene = sceneOf(box({0, 0, 0}, {16, 2, 2}, 32), marble(), {0, 30, 50}, 17);
  scene.lighting.points = {{{19, 3, 1}, {40, 40, 40}}};
  renderer().setScene(scene);
  const TreeAndAll images = treeAndAll(treeOptions(96));
  float brightest = 0;
  forEachCovered(images.all,
                 [&](std::size_t i) { brightest = std::max(brightest, images.all.rgba[i]); });
  for (const float part : {1.0F, 1e-1F, 1e-2F, 1e-3F}) {
    const SumErrors errors = errorsWhere(images.tree, images.all, [&](std::size_t i) {
      const float value = images.all.rgba[i] / brightest;
      return value <= part && value > part / 10;
    });
    EXPECT_GT(errors.pixels, 50) << part;
    expectWithin(0.01, errors, "dark");
  }
}

// Each channel's flux has a centroid of its own: with one for all, red would seem to come from
// where the blue light enters.
TEST_F(TreeTest, ColouredLightsFromDifferentSides) {
  Scene scene = sceneOf(sphere({0, 0, 0}, 6, 4), marble(), {0, 8, 24}, 7);
  scene.lighting.directional = {
      {{1, 0, 0}, {3, 0, 0}}, {{-1, 0, 0}, {0, 0, 3}}, {toVec3(unit({0, -1, -1})), {0, 3, 0}}};
  renderer().setScene(scene);
  for (const float tolerance : {0.1F, 0.01F}) {
    RenderOptions options = treeOptions(64);
    options.tolerance = tolerance;
    const TreeAndAll images = treeAndAll(options);
    expectWithin(static_cast<double>(tolerance), errorsOf(images.tree, images.all), "colours");
  }
}

// The tree is that of the rest pose, its nodes are of this frame's surface.
TEST_F(TreeTest, ATwistedAndBentBodyIsAsGoodAsOneAtRest) {
  Scene scene = backlitBear(25, marble());
  RenderOptions options = treeOptions(40);
  renderer().setScene(scene);
  const double atRest = meanOf(render(options, {Aov::Evaluations})[0])[0];
  scene.deformers = {{DeformerKind::Twist, 2, 0}, {DeformerKind::Bend, 1, 0}};
  renderer().setScene(scene);
  const TreeAndAll images = treeAndAll(options);
  expectWithin(0.01, errorsOf(images.tree, images.all), "twisted and bent");
  const double moved = meanOf(render(options, {Aov::Evaluations})[0])[0];
  EXPECT_LT(moved, 1.5 * atRest);
}

// B = E · D(2R), as in scatter_test.cpp, with surfels many times as large as the profile is wide.
TEST_F(TreeTest, CoarseSurfelsKeepWhatTheySendNearby) {
  constexpr double radiusMm = 20;
  Scene scene = sceneOf(sphere({0, 0, 0}, 20, 4), marble(), {0, 0, 80}, 21);
  scene.lighting.ambient = {1, 1, 1};
  renderer().setScene(scene);
  for (const Transport transport : {Transport::Dipole, Transport::BetterDipole})
    for (const Site site : {Site::Fragment, Site::Vertex}) {
      RenderOptions options = treeOptions(48, site);
      options.maxSurfels = 1024;
      options.transport = transport;
      options.sum = Sum::Tree;
      const Image exitance = render(options, {Aov::Exitance})[0];
      std::array<double, 3> exact{};
      for (int c = 0; c < 3; ++c)
        exact[static_cast<std::size_t>(c)] =
            std::numbers::pi * bssrdf::meanTransmittance(1.5) *
            bssrdf::makeProfile(transport == Transport::Dipole ? bssrdf::Model::Dipole
                                                               : bssrdf::Model::BetterDipole,
                                bssrdf::coefficients(marble(), c))
                .disc(2 * radiusMm);
      double squares = 0;
      double largest = 0;
      const int covered = forEachCovered(exitance, [&](std::size_t i) {
        for (std::size_t c = 0; c < 3; ++c) {
          const double off = static_cast<double>(exitance.rgba[i + c]) / exact[c] - 1;
          squares += off * off / 3;
          largest = std::max(largest, std::abs(off));
        }
      });
      EXPECT_LT(std::sqrt(squares / covered), 0.01);
      EXPECT_LT(largest, 0.03);
    }
}

// A plate thinner than its surfels are long, lit from one side: hardly a surfel has triangles of
// both, and what is nearby on the other side is not taken for the place's own. Surfels joined by
// places alone were off by 35 %.
TEST_F(TreeTest, CoarseSurfelsTellTheSidesOfAThinPlateApart) {
  constexpr float halfMm = 12;
  constexpr float borderMm = 3;
  const Mesh plate = together(sheet({0, 0, 0.25F}, {halfMm, 0, 0}, {0, halfMm, 0}),
                              sheet({0, 0, -0.25F}, {halfMm, 0, 0}, {0, -halfMm, 0}));
  Scene scene = sceneOf(plate, marble(), {8, 5, 40}, 14);
  for (const float side : {1.0F, -1.0F}) {
    scene.lighting.directional = {{{0, 0, side}, {3, 3, 3}}};
    renderer().setScene(scene);
    RenderOptions options = treeOptions(48);
    options.tolerance = 0.003F;
    const std::vector<Image> fine = render(options, {Aov::Exitance, Aov::Position});
    for (const int maxSurfels : {2048, 8192}) {  // two triangles a surfel, and one
      options.maxSurfels = maxSurfels;
      const Image coarse = render(options, {Aov::Exitance})[0];
      const SumErrors errors = errorsWhere(coarse, fine[0], [&](std::size_t i) {
        const float* place = &fine[1].rgba[i];
        return std::max(std::abs(place[0]), std::abs(place[1])) < halfMm - borderMm;
      });
      EXPECT_GT(errors.pixels, 500);
      EXPECT_LT(errors.rms, maxSurfels == 2048 ? 0.08 : 0.01) << side;
    }
  }
}

double percentile99(std::vector<double> values) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(values.size()));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Steps of the error from pixel to pixel, where tiles of the picture meet and inside them.
TEST_F(TreeTest, TilesOfThePictureLeaveNoSeams) {
  constexpr int tile = 8;
  Scene scene = sceneOf(sphere({0, 0, 0}, 8, 4), skin(), {0, 4, 32}, 8.2F);
  scene.lighting.directional = {{{0.45F, 0.35F, -0.82F}, {3, 3, 3}}};
  renderer().setScene(scene);
  const int edge = 160;
  const TreeAndAll images = treeAndAll(treeOptions(edge));
  const std::array<double, 3> mean = meanOf(images.all);
  const auto error = [&](int x, int y) {
    return static_cast<double>(images.tree.pixel(x, y)[1] - images.all.pixel(x, y)[1]) / mean[1];
  };
  std::vector<double> across;
  std::vector<double> inside;
  for (int y = 0; y < edge; ++y)
    for (int x = 0; x < edge; ++x) {
      if (images.all.pixel(x, y)[3] <= 0) continue;
      if (x + 1 < edge && images.all.pixel(x + 1, y)[3] > 0)
        ((x + 1) % tile == 0 ? across : inside).push_back(std::abs(error(x + 1, y) - error(x, y)));
      if (y + 1 < edge && images.all.pixel(x, y + 1)[3] > 0)
        ((y + 1) % tile == 0 ? across : inside).push_back(std::abs(error(x, y + 1) - error(x, y)));
    }
  ASSERT_GT(across.size(), 2000U);
  EXPECT_LE(percentile99(across), 1.2 * percentile99(inside));
}

}  // namespace
}  // namespace opaline
