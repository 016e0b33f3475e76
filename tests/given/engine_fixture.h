#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "given/engine.h"
#include "renderer/wobbly_ball.h"

namespace opaline::test {

/// A test with an engine. Any message of the validation layer is a failure, including those about
/// objects left when the device is destroyed.
class EngineTest : public testing::Test {
 protected:
  explicit EngineTest(bool validated = true) : validated_(validated) {}
  void SetUp() override { engine_ = std::make_unique<Engine>(validated_); }
  void TearDown() override {
    if (engine_) reportMessages();
  }
  void reportMessages() {
    for (const std::string& message : engine_->messages()) ADD_FAILURE() << message;
  }

  Engine& engine() { return *engine_; }

  static RenderOptions tinyOptions() {
    RenderOptions options;
    options.width = options.height = 32;
    options.maxSurfels = 2048;
    options.maxClusters = 256;
    options.shadowSize = 128;
    options.dsmSize = 128;
    return options;
  }

  /// The same images from a renderer with its own device.
  static std::vector<Image> alone(const Scene& scene, const RenderOptions& options,
                                  const std::vector<Aov>& aovs = {Aov::Radiance}) {
    Renderer renderer;
    renderer.setScene(scene);
    return renderer.render(options, aovs).images;
  }

 private:
  bool validated_;
  std::unique_ptr<Engine> engine_;
};

}  // namespace opaline::test
