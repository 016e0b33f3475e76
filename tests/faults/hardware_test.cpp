// Where the device says that it is hardware, work is divided more finely and tables are read as
// storage. Where its buffers are small, less is kept. The picture is the same.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

struct Claims {
  bool hardware = false;
  std::uint32_t texels = 0;  ///< of a buffer; 0: the device's own
};

std::vector<float> pictureOf(const Scene& scene, const RenderOptions& options,
                             const Claims& claims) {
  faultLayer().claimHardware(claims.hardware);
  faultLayer().claimTexels(claims.texels);
  Renderer renderer;
  faultLayer().claimHardware(false);
  faultLayer().claimTexels(0);
  renderer.setScene(scene);
  const RenderResult result = renderer.render(options);
  EXPECT_EQ(result.report.device.type == "discrete", claims.hardware);
  return result.images.at(0).rgba;
}

/// Root mean square difference over the largest of the first.
double difference(const std::vector<float>& one, const std::vector<float>& other) {
  EXPECT_EQ(one.size(), other.size());
  const float largest = *std::max_element(one.begin(), one.end());
  EXPECT_GT(largest, 0.01F);
  double squares = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const double off = static_cast<double>(other.at(i)) - static_cast<double>(one[i]);
    squares += off * off;
  }
  return std::sqrt(squares / static_cast<double>(one.size())) / static_cast<double>(largest);
}

/// From what the device makes without claims.
double difference(const Scene& scene, const RenderOptions& options, const Claims& claims) {
  return difference(pictureOf(scene, options, {}), pictureOf(scene, options, claims));
}

TEST(Hardware, MakesTheSamePictureOfLightThatIsFollowedOn) {
  Medium dark = skin();
  dark.g = 0.8;
  EXPECT_LT(difference(twoBalls(dark), smallOptions(), {.hardware = true}), 2e-5);
}

TEST(Hardware, MakesTheSamePictureOfAHalfSpace) {
  RenderOptions options = smallOptions();
  options.transport = Transport::Dipole;
  for (const Site site : {Site::Vertex, Site::Fragment}) {
    options.site = site;
    EXPECT_LT(difference(twoBalls(marble()), options, {.hardware = true}), 2e-5);
  }
}

RenderOptions optionsOfManyClusters() {
  RenderOptions options = smallOptions();
  options.maxClusters = 768;
  options.maxSurfels = 2048;
  options.tolerance = 0.002F;
  return options;
}

// Buffers that hold the coefficients of some nodes and not of others, which are found anew in each
// step. Those that are kept are rounded.
TEST(Hardware, OfSmallBuffersMakesTheSamePicture) {
  const double off = difference(twoBalls(marble()), optionsOfManyClusters(), {.texels = 80000});
  EXPECT_GT(off, 0);
  EXPECT_LT(off, 3e-4);
}

// They do not hold all either of what light from everywhere gives to clusters of skin.
TEST(Hardware, OfSmallBuffersMakesTheSamePictureOfLightFromEverywhere) {
  Scene scene = twoBalls(skin());
  scene.objects.pop_back();
  const double off = difference(scene, optionsOfManyClusters(), {.texels = 80000});
  EXPECT_GT(off, 0);
  EXPECT_LT(off, 3e-4);
}

// The finest tolerance with coefficients that are kept, and the next finer one.
TEST(Hardware, KeepsCoefficientsThatAreRight) {
  Medium forwards = skin();
  forwards.g = 0.8;
  for (const Medium& medium : {skin(), forwards}) {
    RenderOptions exact = optionsOfManyClusters();
    exact.tolerance = std::nextafter(exact.tolerance, 0.0F);
    const std::vector<float> kept = pictureOf(twoBalls(medium), optionsOfManyClusters(), {});
    const double off = difference(kept, pictureOf(twoBalls(medium), exact, {}));
    EXPECT_GT(off, 0);
    EXPECT_LT(off, 3e-4);
  }
}

}  // namespace
}  // namespace opaline
