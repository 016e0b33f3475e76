// Interpolation between sums at fragments, against summing all sources at every pixel: most pixels
// need no sum, nothing is interpolated across edges, and details between sums are found.

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "opaline/view.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"
#include "renderer/sums.h"

namespace opaline {
namespace {

using namespace test;

using InterpolationTest = RendererTest;

RenderOptions atFragments(int edge, Transport transport) {
  RenderOptions options = smallOptions();
  options.width = options.height = edge;
  options.transport = transport;
  options.site = Site::Fragment;
  return options;
}

double shareOfCoveredBelow(const Image& image, float limit) {
  int below = 0;
  const int covered =
      forEachCovered(image, [&](std::size_t i) { below += image.rgba[i] < limit ? 1 : 0; });
  return static_cast<double>(below) / covered;
}

Scene ballLitFromTheSide(const Medium& medium) {
  Scene scene = sceneOf(sphere({0, 0, 0}, 4), medium, {0, 0, 30}, 4.2F);
  scene.lighting.directional = {{toVec3(unit({1, 0.3, 0.1})), {3, 3, 3}}};
  return scene;
}

TEST_F(InterpolationTest, MostPixelsOfASmoothSurfaceNeedNoSum) {
  renderer().setScene(ballLitFromTheSide(marble()));
  const RenderOptions options = atFragments(192, Transport::Dipole);
  const TreeAndAll images = treeAndAll(options);
  const SumErrors errors = errorsOf(images.tree, images.all);
  EXPECT_LT(errors.rms, 0.004);
  EXPECT_LT(errors.localLargest, 0.02);
  const Image evaluations = render(options, {Aov::Evaluations})[0];
  EXPECT_GT(shareOfCoveredBelow(evaluations, 1), 0.6);
}

TEST_F(InterpolationTest, PixelsFartherApartThanFreePathsEachHaveTheirSum) {
  Medium dense = marble();
  for (std::size_t c = 0; c < 3; ++c) dense.sigmaSPrimePerMm[c] *= 4;
  renderer().setScene(ballLitFromTheSide(dense));
  const Image evaluations = render(atFragments(64, Transport::Dipole), {Aov::Evaluations})[0];
  EXPECT_EQ(shareOfCoveredBelow(evaluations, 1), 0);
}

// A lit box fills one half of the picture, in front of a dark one. The edge lies between pixels.
TEST_F(InterpolationTest, NothingIsTakenAcrossAnEdge) {
  Scene scene = sceneOf(together(box({-3, 0, 3}, {3, 6, 1}), box({3, 0, -6}, {6, 6, 1})), marble(),
                        {0, 0, 40}, 4);
  scene.lighting.directional = {{toVec3(unit({-1, 0, 0.3})), {3, 3, 3}}};
  renderer().setScene(scene);
  // The edge passes through the middle of a block, and along the side of one.
  for (const int edge : {100, 96}) {
    const TreeAndAll images = treeAndAll(atFragments(edge, Transport::Dipole));
    EXPECT_LT(errorsOf(images.tree, images.all).localLargest, 0.02) << edge;
  }
}

TEST_F(InterpolationTest, CarriedLightIsAsWithASumForEveryPixel) {
  renderer().setScene(ballLitFromTheSide(skin()));
  const TreeAndAll images = treeAndAll(atFragments(128, Transport::Boundary));
  const SumErrors errors = errorsOf(images.tree, images.all);
  EXPECT_LT(errors.rms, 0.01);
  EXPECT_LT(errors.localLargest, 0.03);
}

// Pictures with more samples fill layers that other pictures do not have.
TEST_F(InterpolationTest, APictureOfMoreSamplesLeavesNothingBehind) {
  renderer().setScene(ballLitFromTheSide(skin()));
  RenderOptions options = atFragments(64, Transport::Boundary);
  options.antialias = 4;
  View view(renderer(), options);
  view.render({.aovs = {Aov::Radiance}});
  const Image after = view.render({.aovs = {Aov::Exitance}}).images[0];
  const Image fresh = View(renderer(), options).render({.aovs = {Aov::Exitance}}).images[0];
  EXPECT_EQ(after.rgba, fresh.rgba);
}

}  // namespace
}  // namespace opaline
