#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "opaline/error.h"
#include "opaline/renderer.h"

namespace opaline::test {

/// The renderer of all tests in a process, created at first use with the validation layer on, and
/// the messages of that layer.
struct SharedRenderer {
  std::unique_ptr<Renderer> renderer;
  std::string reason;  ///< why there is none
  bool opened = false;
  std::vector<std::string> messages;

  RendererOptions options() {
    RendererOptions options;
    options.validation = true;
    options.log = [this](LogLevel level, std::string_view message) {
      if (level == LogLevel::Warning) messages.emplace_back(message);
    };
    return options;
  }
  void open() {
    if (std::exchange(opened, true)) return;
    try {
      renderer = std::make_unique<Renderer>(options());
    } catch (const Error& error) {
      reason = error.what();
    }
  }
  /// Any message fails the current test.
  void reportMessages() {
    for (const std::string& message : std::exchange(messages, {})) ADD_FAILURE() << message;
  }
};

inline SharedRenderer& sharedRenderer() {
  static SharedRenderer shared;
  return shared;
}

/// Destroys the renderer after the last test; the layer then reports objects that were left behind.
class CloseSharedRenderer : public testing::Environment {
 public:
  void TearDown() override {
    sharedRenderer().renderer.reset();
    sharedRenderer().reportMessages();
  }
};

inline const testing::Environment* const closeSharedRenderer =
    testing::AddGlobalTestEnvironment(new CloseSharedRenderer);

/// A test through the public renderer: fails where there is no device, and on any validation
/// message.
template <typename Base>
class RendererTestBase : public Base {
 protected:
  void SetUp() override {
    sharedRenderer().open();
    ASSERT_NE(sharedRenderer().renderer, nullptr)
        << "these tests need a Vulkan device and the validation layer: " << sharedRenderer().reason;
    messagesBefore_ = renderer().validationMessages();
  }
  void TearDown() override {
    sharedRenderer().reportMessages();
    if (sharedRenderer().renderer) {
      EXPECT_EQ(renderer().validationMessages(), messagesBefore_);
    }
  }

  static Renderer& renderer() { return *sharedRenderer().renderer; }

  static std::vector<Image> render(const RenderOptions& options, const std::vector<Aov>& aovs) {
    return renderer().render(options, aovs).images;
  }
  static std::vector<Image> render(const Scene& scene, const RenderOptions& options,
                                   const std::vector<Aov>& aovs) {
    renderer().setScene(scene);
    return render(options, aovs);
  }
  static std::vector<Image> renderAt(double seconds, const RenderOptions& options,
                                     const std::vector<Aov>& aovs) {
    renderer().setTime({.seconds = seconds});
    return render(options, aovs);
  }

 private:
  std::size_t messagesBefore_ = 0;
};

using RendererTest = RendererTestBase<testing::Test>;

/// Small pictures with a coarse division, by the transport that has closed forms.
inline RenderOptions smallOptions() {
  RenderOptions options;
  options.transport = Transport::Dipole;
  options.width = 64;
  options.height = 64;
  options.dsmSize = 256;
  options.shadowSize = 512;
  options.maxSurfels = 8192;
  options.maxClusters = 1024;
  options.antialias = 1;
  return options;
}

/// Divided as finely as by default, where few surfels are not exact enough.
inline RenderOptions finelyDivided(RenderOptions options) {
  options.maxSurfels = RenderOptions{}.maxSurfels;
  options.maxClusters = RenderOptions{}.maxClusters;
  return options;
}

/// Calls `check` with the index of every pixel that is covered; returns how many there are.
template <typename Check>
int forEachCovered(const Image& image, const Check& check) {
  int count = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    if (image.rgba[i + 3] <= 0) continue;
    ++count;
    check(i);
    if (testing::Test::HasFatalFailure()) break;
  }
  return count;
}

}  // namespace opaline::test
