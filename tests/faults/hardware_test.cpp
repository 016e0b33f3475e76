// Where the device says that it is hardware, work is divided more finely and tables are read as
// storage. The picture is the same.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "faults/fault_layer.h"
#include "faults/tiny_options.h"
#include "opaline/renderer.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;

RenderOptions smallOptions() {
  RenderOptions options = tinyOptions();
  options.width = options.height = 32;
  options.maxClusters = 128;
  options.antialias = 2;
  return options;
}

/// With light that is followed to its second collisions, a sky, an area light and a shadow on the
/// ball.
Scene twoBalls(const Medium& medium) {
  Scene scene = sceneOf(sphere({0, 0, 0}, 5, 2), medium, {0, 0, 30}, 8);
  scene.objects.push_back({"smaller", sphere({5, 4, 3}, 2, 1), marble()});
  scene.lighting.directional = {{{0.3F, 0.5F, 0.8F}, {1, 1, 1}},
                                {{-1, 0.2F, -0.3F}, {1, 0.5F, 0.2F}}};
  scene.lighting.ambient = {0.3F, 0.4F, 0.5F};
  scene.lighting.areas = {
      RectangleLight{.centreMm = {-20, 0, 0}, .uMm = {0, 5, 0}, .vMm = {0, 0, 5}}};
  return scene;
}

std::vector<float> pictureOf(const Scene& scene, const RenderOptions& options, bool asHardware) {
  faultLayer().claimHardware(asHardware);
  Renderer renderer;
  faultLayer().claimHardware(false);
  renderer.setScene(scene);
  const RenderResult result = renderer.render(options);
  EXPECT_EQ(result.report.device.type == "discrete", asHardware);
  return result.images.at(0).rgba;
}

void expectSame(const Scene& scene, const RenderOptions& options) {
  const std::vector<float> software = pictureOf(scene, options, false);
  const std::vector<float> hardware = pictureOf(scene, options, true);
  ASSERT_EQ(software.size(), hardware.size());
  const float largest = *std::max_element(software.begin(), software.end());
  EXPECT_GT(largest, 0.01F);
  double squares = 0;
  for (std::size_t i = 0; i < software.size(); ++i) {
    const double difference = static_cast<double>(hardware[i]) - static_cast<double>(software[i]);
    squares += difference * difference;
  }
  EXPECT_LT(std::sqrt(squares / static_cast<double>(software.size())), 2e-5 * largest);
}

TEST(Hardware, MakesTheSamePictureOfLightThatIsFollowedOn) {
  Medium dark = skin();
  dark.g = 0.8;
  expectSame(twoBalls(dark), smallOptions());
}

TEST(Hardware, MakesTheSamePictureOfAHalfSpace) {
  RenderOptions options = smallOptions();
  options.transport = Transport::Dipole;
  for (const Site site : {Site::Vertex, Site::Fragment}) {
    options.site = site;
    expectSame(twoBalls(marble()), options);
  }
}

}  // namespace
}  // namespace opaline
