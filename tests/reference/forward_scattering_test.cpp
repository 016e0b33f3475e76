// Boundary transport in a forward-scattering medium, against paths that follow Henyey and
// Greenstein's phase function itself.

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "opaline/media.h"
#include "reference/bodies.h"
#include "reference/path/path_tracer.h"
#include "reference/truth.h"
#include "renderer/renderer_fixture.h"

namespace opaline {
namespace {

using namespace test;

Scene ballOf(const Medium& medium, const Vec3& toLight) {
  Scene scene;
  scene.objects.push_back({.name = "ball", .mesh = sphere({0, 0, 0}, 8, 4), .medium = medium});
  scene.lighting.directional = {{toLight, {1, 1, 1}}};
  scene.camera.positionMm = {0, 0, 60};
  scene.camera.verticalFovDegrees = 18;
  return scene;
}

std::array<double, 3> meansOf(const Image& image) {
  std::array<double, 3> sums{};
  double covered = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    if (image.rgba[i + 3] == 0) continue;
    covered += 1;
    for (std::size_t c = 0; c < 3; ++c) sums[c] += double{image.rgba[i + c]};
  }
  for (double& sum : sums) sum /= covered;
  return sums;
}

class ForwardScatteringTest : public RendererTest {
 protected:
  static constexpr int edge = 24;

  std::array<double, 3> rendered(const Scene& scene) {
    RenderOptions options;
    options.width = options.height = edge;
    options.transport = Transport::Boundary;
    options.bounces = 0;
    options.maxSurfels = 16'384;
    renderer().setScene(scene);
    return meansOf(render(options, {Aov::Exitance})[0]);
  }

  static std::array<double, 3> traced(const Scene& scene, std::uint64_t particles) {
    const reference::Scene posed = referenceOf(scene);
    const reference::Geometry geometry(posed);
    const reference::Irradiance irradiance(geometry);
    reference::PathTracer tracer(geometry, {.bounces = 0, .cellMm = 1.5});
    tracer.run(particles);
    reference::PictureOptions picture;
    picture.width = picture.height = edge;
    picture.aov = Aov::Exitance;
    return meansOf(pathTruth(tracer, geometry, irradiance, picture).image);
  }
};

// Isotropic scattering with the same reduced coefficients would be 3, 10 and 19 % too bright here.
TEST_F(ForwardScatteringTest, AbsorbingBallIsAsBrightAsPathsSay) {
  Medium medium = *findMedium("skin1");
  medium.g = 0.9;
  const Scene scene = ballOf(medium, {0.5F, 0.3F, 0.8F});
  const auto found = rendered(scene);
  const auto truth = traced(scene, 70'000);
  const std::array<double, 3> most{0.02, 0.035, 0.08};
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c] / truth[c], 1, most[c]) << c;
}

// Similarity (van de Hulst 1980): with little absorption and a thick body, g has no visible effect.
TEST_F(ForwardScatteringTest, ThickWhiteBallsLookAlike) {
  Medium medium{"white", {4, 4, 4}, {0.004, 0.004, 0.004}, 1.4};
  const Vec3 toLight{0.5F, 0.3F, 0.8F};
  const auto even = rendered(ballOf(medium, toLight));
  medium.g = 0.8;
  const auto forward = rendered(ballOf(medium, toLight));
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(forward[c] / even[c], 1, 0.01) << c;
}

}  // namespace
}  // namespace opaline
