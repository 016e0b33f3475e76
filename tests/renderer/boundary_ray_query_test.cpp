// Boundary transport with rays by VK_KHR_ray_query against the same with rays by compute shaders.

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "renderer/boundary_fixture.h"

namespace opaline {
namespace {

using namespace test;

/// The index of such a device; empty where there is none.
std::string deviceWithRayQueries() {
  const std::vector<DeviceDescription> devices = listDevices();
  for (std::size_t i = 0; i < devices.size(); ++i)
    if (devices[i].rayQueries) return std::to_string(i);
  return {};
}

class BoundaryRayQueryTest : public RendererTest {
 protected:
  void SetUp() override {
    RendererTest::SetUp();
    if (deviceWithRayQueries().empty()) GTEST_SKIP() << "no device has VK_KHR_ray_query";
    if (withQueries_) return;
    for (auto* made : {&withQueries_, &without_}) {
      RendererOptions options = sharedRenderer().options();
      options.rayQueries = made == &withQueries_;
      options.device = deviceWithRayQueries();
      *made = std::make_unique<Renderer>(options);
    }
  }

  static void TearDownTestSuite() {
    withQueries_.reset();
    without_.reset();
  }

  static void expectTheSame(const Scene& scene, const std::vector<double>& times) {
    withQueries_->setScene(scene);
    without_->setScene(scene);
    RenderOptions options = boundaryOptions(64, 1);
    options.maxClusters = 1500;
    options.maxSurfels = 6000;
    for (const double seconds : times) {
      withQueries_->setTime({.seconds = seconds});
      without_->setTime({.seconds = seconds});
      const RenderResult a = withQueries_->render(options, {Aov::Exitance});
      const RenderResult b = without_->render(options, {Aov::Exitance});
      ASSERT_TRUE(a.report.device.rayQueries);
      const SumErrors errors = errorsOf(a.images[0], b.images[0]);
      EXPECT_GT(errors.pixels, 500);
      EXPECT_LT(errors.rms, 1e-3) << "at " << seconds << " s";
    }
  }

 private:
  // Shared by all tests, as new renderers compile all shaders again.
  static inline std::unique_ptr<Renderer> withQueries_;
  static inline std::unique_ptr<Renderer> without_;
};

// Covers rays through the body, reflections, second collisions, and what the body sees of itself.
TEST_F(BoundaryRayQueryTest, ATwistingBearIsTheSame) {
  Scene bear = backlitBear(50, {"gummy", {1.0, 1.0, 1.0}, {0.02, 0.3, 0.4}, 1.4});
  bear.deformers = {{DeformerKind::Twist, 1.5F, 2}};
  expectTheSame(bear, {0.3});
}

// Covers rays within and between more bodies than there are classes of them.
TEST_F(BoundaryRayQueryTest, ManyBodiesAreTheSame) {
  const Medium milky{"milky", {6, 6, 6}, {1e-3F, 1e-2F, 1e-1F}, 1.3F};
  Scene scene = sceneOf(sphere({0, 0, 0}, 2, 3), milky, {0, 0, 40}, 8);
  for (int i = 1; i < 18; ++i) {
    const auto x = static_cast<float>(i % 6);
    const auto y = static_cast<float>(i / 6);
    scene.objects.push_back({"ball", sphere({2.6F * x, 2.9F * y, 0.4F * x}, 1.2F, 3), milky});
  }
  scene.lighting.directional = {{{0.45F, 0.35F, -0.82F}, {3, 3, 3}}};
  scene.lighting.ambient = {0.2F, 0.2F, 0.2F};
  expectTheSame(scene, {0});
}

}  // namespace
}  // namespace opaline
