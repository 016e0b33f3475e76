// What sums over surfels do where things come close to a limit.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"
#include "renderer/sums.h"

namespace opaline {
namespace {

using namespace test;

using TreeLimitsTest = RendererTest;

RenderOptions fragments() {
  RenderOptions options = smallOptions();
  options.width = options.height = 32;
  options.site = Site::Fragment;
  return options;
}

// Exitance belongs to a point of the surface, whichever side of it is seen.
TEST_F(TreeLimitsTest, APlateOfCoarseSurfelsIsTheSameFromBothSides) {
  const Mesh plate = sheet({0, 0, 0}, {400, 0, 0}, {0, 400, 0});
  RenderOptions options = fragments();
  options.maxSurfels = 1024;
  std::vector<std::array<double, 3>> means;
  for (const float z : {1000.0F, -1000.0F}) {
    Scene scene = sceneOf(plate, marble(), {0, 0, z}, 200);
    scene.lighting.directional = {{{0, 0, 1}, {3, 3, 3}}};
    means.push_back(meanOf(render(scene, options, {Aov::Exitance})[0]));
  }
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_GT(means[0][c], 0.1);
    EXPECT_NEAR(means[1][c] / means[0][c], 1, 1e-3);
  }
}

TEST_F(TreeLimitsTest, TheFaintestLightIsStillANumber) {
  Scene scene = sceneOf(sphere({0, 0, 0}, 6, 3), skin(), {0, 3, 24}, 7);
  for (const float irradiance : {1e-26F, 1e-30F, 1e-34F, 1e-38F}) {
    scene.lighting.directional = {{{0, 0, 1}, {irradiance, irradiance, irradiance}}};
    const Image found = render(scene, fragments(), {Aov::Exitance})[0];
    forEachCovered(found, [&](std::size_t i) {
      for (std::size_t c = 0; c < 3; ++c) {
        ASSERT_TRUE(std::isfinite(found.rgba[i + c])) << irradiance;
        ASSERT_GE(found.rgba[i + c], 0);
        ASSERT_LE(found.rgba[i + c], irradiance);
      }
    });
  }
}

// Rays through surfels of a hundred triangles each go through many more than where each is one, and
// devices may limit how long a loop is.
TEST_F(TreeLimitsTest, LightDoesNotDependOnHowManyTrianglesAreInASurfel) {
  RenderOptions options = fragments();
  options.transport = Transport::Boundary;
  options.bounces = 1;
  options.maxSurfels = 1024;
  options.maxClusters = 512;
  std::vector<Image> found;
  for (const int cells : {8, 64}) {
    const Mesh left = box({-6, 0, 0}, {4, 8, 4}, cells);
    const Mesh right = box({6, 0, 0}, {4, 8, 4}, cells);
    Scene scene = sceneOf(together(left, right), skin(), {20, 10, 40}, 12);
    scene.lighting.ambient = {1, 1, 1};
    found.push_back(render(scene, options, {Aov::Exitance})[0]);
  }
  EXPECT_LT(errorsOf(found[1], found[0]).rms, 0.03);
}

// Every pass there is, as often as there may be.
TEST_F(TreeLimitsTest, AFrameMayHaveAllItsPasses) {
  Scene scene = sceneOf(sphere({0, 0, 0}, 300, 4), marble(), {0, 0, 900}, 400);
  scene.objects.push_back({"coarse", box({400, 0, 0}, {50, 50, 50}, 1), skin()});
  scene.lighting.directional = {{{0, 0, 1}, {3, 3, 3}}};
  scene.deformers = {{DeformerKind::Twist, 0.5F, 0}};
  renderer().setScene(scene);
  RenderOptions options = fragments();
  options.site = Site::Auto;
  options.maxSurfels = 4096;
  options.antialias = 8;
  EXPECT_NO_THROW(render(options, {Aov::Radiance, Aov::Exitance, Aov::Irradiance}));
}

// Far apart vertices are bright, and what lies between them in the shadow of another body is dark.
TEST_F(TreeLimitsTest, TheDarkMiddleOfACoarsePlateIsNotTakenForItsBrightCorners) {
  Scene scene = sceneOf(sheet({0, 0, 0}, {20, 0, 0}, {0, 20, 0}, 1), skin(), {0, 0, 60}, 20);
  scene.objects.push_back({"shade", sheet({26, 0, 26}, {17, 0, 0}, {0, 17, 0}, 1), marble()});
  scene.lighting.directional = {{toVec3(unit({1, 0, 1})), {3, 3, 3}}};
  renderer().setScene(scene);
  RenderOptions options = fragments();
  const std::vector<Image> tree = render(options, {Aov::Exitance, Aov::Object});
  options.sum = Sum::All;
  const Image all = render(options, {Aov::Exitance})[0];
  const SumErrors errors =
      errorsWhere(tree[0], all, [&](std::size_t i) { return tree[1].rgba[i] == 0; });
  EXPECT_GT(errors.pixels, 200);
  EXPECT_LT(errors.localLargest, 0.02);
}

}  // namespace
}  // namespace opaline
