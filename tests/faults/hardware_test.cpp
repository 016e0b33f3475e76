// Devices that claim to be hardware divide work more finely and read tables as storage. With small
// buffers, less is kept. The picture stays the same.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
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

/// A scene whose light is followed to second collisions, with a sky, an area light and a shadow on
/// the ball.
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

/// The device's index as a name; empty where there is none.
std::string softwareDevice() {
  const std::vector<DeviceDescription> devices = listDevices();
  for (std::size_t i = 0; i < devices.size(); ++i)
    if (devices[i].type == "software") return std::to_string(i);
  return {};
}

/// Tests on a software device, even if the best device is hardware, which works that way anyway.
class Hardware : public testing::Test {
 protected:
  void SetUp() override {
    faultLayer();
    if (softwareDevice().empty())
      GTEST_SKIP() << "there is no software device, which could work as hardware does";
  }
};

struct Claims {
  bool hardware = false;
  std::uint32_t texels = 0;  ///< of a buffer; 0: the device's own
};

std::vector<float> pictureOf(const Scene& scene, const RenderOptions& options, const Claims& claims,
                             Aov aov = Aov::Radiance) {
  RendererOptions software;
  software.device = softwareDevice();
  faultLayer().claimHardware(claims.hardware);
  faultLayer().claimTexels(claims.texels);
  Renderer renderer(software);
  faultLayer().claimHardware(false);
  faultLayer().claimTexels(0);
  renderer.setScene(scene);
  const RenderResult result = renderer.render(options, {Aov::Radiance, aov});
  EXPECT_EQ(result.report.device.type == "discrete", claims.hardware);
  return result.images.back().rgba;
}

/// Samples very close to a triangle's side may see another triangle: the software device rounds
/// corners to a grid of 256 places per pixel, while drawing by invocations does not.
constexpr std::size_t pixelsOfSides = 2;  // of 32x32
constexpr double mostAtSides = 0.01;      // of the largest value

/// Root mean square difference relative to the largest value of the first, over all pixels except
/// the `without` that differ most.
double difference(const std::vector<float>& one, const std::vector<float>& other,
                  std::size_t without = 0) {
  EXPECT_EQ(one.size(), other.size());
  const auto largest = static_cast<double>(*std::max_element(one.begin(), one.end()));
  EXPECT_GT(largest, 0.01);
  std::vector<double> squares(one.size() / 4);  // of pixels
  for (std::size_t i = 0; i < one.size(); ++i) {
    const double off = static_cast<double>(other.at(i)) - static_cast<double>(one[i]);
    squares[i / 4] += off * off / (largest * largest);
  }
  std::sort(squares.rbegin(), squares.rend());
  EXPECT_LT(std::sqrt(squares.at(0)), mostAtSides);
  const auto rest = squares.begin() + static_cast<std::ptrdiff_t>(without);
  return std::sqrt(std::accumulate(rest, squares.end(), 0.0) / static_cast<double>(one.size()));
}

/// The difference from the picture that the device makes without claims.
double difference(const Scene& scene, const RenderOptions& options, const Claims& claims,
                  Aov aov = Aov::Radiance) {
  return difference(pictureOf(scene, options, {}, aov), pictureOf(scene, options, claims, aov),
                    claims.hardware ? pixelsOfSides : 0);
}

TEST_F(Hardware, MakesTheSamePictureOfLightThatIsFollowedOn) {
  Medium dark = skin();
  dark.g = 0.8;
  EXPECT_LT(difference(twoBalls(dark), smallOptions(), {.hardware = true}), 2e-6);
}

TEST_F(Hardware, MakesTheSamePictureOfAHalfSpace) {
  RenderOptions options = smallOptions();
  options.transport = Transport::Dipole;
  for (const Site site : {Site::Vertex, Site::Fragment}) {
    options.site = site;
    EXPECT_LT(difference(twoBalls(marble()), options, {.hardware = true}), 2e-6);
  }
}

// A pixel's centre is not one of its samples.
TEST_F(Hardware, SeesTheSameAtTheCentresOfPixels) {
  RenderOptions options = smallOptions();
  options.transport = Transport::Dipole;
  options.antialias = 4;
  EXPECT_LT(difference(twoBalls(marble()), options, {.hardware = true}, Aov::Position), 2e-6);
}

RenderOptions optionsOfManyClusters() {
  RenderOptions options = smallOptions();
  options.maxClusters = 768;
  options.maxSurfels = 2048;
  options.tolerance = 0.002F;
  return options;
}

// The buffers hold the coefficients of some nodes only; those of others are recomputed in each
// step. Stored ones are rounded.
TEST_F(Hardware, OfSmallBuffersMakesTheSamePicture) {
  const double off = difference(twoBalls(marble()), optionsOfManyClusters(), {.texels = 80000});
  EXPECT_GT(off, 0);
  EXPECT_LT(off, 3e-4);
}

// They also hold only part of what light from everywhere gives to clusters of skin.
TEST_F(Hardware, OfSmallBuffersMakesTheSamePictureOfLightFromEverywhere) {
  Scene scene = twoBalls(skin());
  scene.objects.pop_back();
  const double off = difference(scene, optionsOfManyClusters(), {.texels = 80000});
  EXPECT_GT(off, 0);
  EXPECT_LT(off, 3e-4);
}

// The finest tolerance with stored coefficients, and the next finer one.
TEST_F(Hardware, KeepsCoefficientsThatAreRight) {
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
