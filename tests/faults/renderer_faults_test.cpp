// Every Vulkan call that can fail does so once. Each failure must give one sentence and leave
// nothing behind. Afterwards the renderer makes the same picture or says that its device is lost.
// OPALINE_FAULT_STRIDE=1 in the environment tests all calls.

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "faults/fault_layer.h"
#include "faults/tiny_options.h"
#include "opaline/error.h"
#include "opaline/renderer.h"
#include "opaline/vulkan.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;

Scene litBall() {
  Scene scene = sceneOf(sphere({0, 0, 0}, 5, 2), marble(), {0, 0, 25}, 6);
  scene.lighting.directional = {{{0.3F, 0.5F, 0.8F}, {1, 1, 1}}};
  scene.lighting.points = {{{20, 0, 0}, {100, 100, 100}}};
  scene.lighting.ambient = {0.1F, 0.1F, 0.1F};
  scene.deformers = {{DeformerKind::Wobble, 0.05F, 1}};
  return scene;
}

std::vector<float> picture(Renderer& renderer, const RenderOptions& options = tinyOptions()) {
  return renderer.render(options).images.at(0).rgba;
}

class Faults : public testing::TestWithParam<VkResult> {
 protected:
  void SetUp() override { ASSERT_EQ(faultLayer().living(), 0); }
  void TearDown() override {
    faultLayer().disarm();
    EXPECT_EQ(faultLayer().living(), 0) << faultLayer().describeLiving();
    std::cout << failed_ << " calls failed" << std::endl;
  }

  /// Whether it did not throw. An exception must be one sentence that blames nobody.
  static bool succeeds(const std::function<void()>& run) {
    try {
      run();
      return true;
    } catch (const UsageError& error) {
      ADD_FAILURE() << "counts as a mistake of the caller: " << error.what();
    } catch (const Error& error) {
      const std::string sentence = error.what();
      EXPECT_FALSE(sentence.empty());
      EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
      EXPECT_EQ(sentence.find("VkResult"), std::string::npos) << sentence;
      EXPECT_FALSE(faultLayer().faulted().empty()) << "nothing failed: " << sentence;
    }
    return false;
  }

  /// Runs `run` with the first failing call, then `after`; then with the following ones, every
  /// `stride`-th, until a run has no more.
  void failEachCall(int stride, const std::function<void()>& run,
                    const std::function<void(bool succeeded)>& after) {
    if (const char* wanted = std::getenv("OPALINE_FAULT_STRIDE")) stride = std::atoi(wanted);
    for (int nth = 1; !HasFailure(); nth += stride) {
      faultLayer().arm(GetParam(), static_cast<std::uint64_t>(nth));
      const bool succeeded = succeeds(run);
      const std::string faulted = faultLayer().faulted();
      faultLayer().disarm();
      SCOPED_TRACE("after call " + std::to_string(nth) + ", " + faulted);
      after(succeeded);
      if (faulted.empty()) return;
      ++failed_;
    }
  }

 private:
  int failed_ = 0;
};

TEST_P(Faults, OpeningLeavesNothing) {
  std::optional<Renderer> renderer;
  const auto open = [&] { renderer.emplace(); };
  failEachCall(19, open, [&](bool opened) {
    EXPECT_EQ(renderer.has_value(), opened);
    renderer.reset();
    EXPECT_EQ(faultLayer().living(), 0) << faultLayer().describeLiving();
  });
}

// The device is already open, and must be closed before its instance.
TEST(FaultsOfDrivers, ADriverWithoutAFunctionIsRefusedAndLeavesNothing) {
  faultLayer();
  for (const char* function : {"vkCreateSemaphore", "vkCmdPipelineBarrier2", "vkQueueSubmit2"}) {
    faultLayer().hide(function);
    try {
      const Renderer renderer;
      ADD_FAILURE() << "opened without " << function;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(function), std::string::npos) << error.what();
    }
    faultLayer().hide(nullptr);
    EXPECT_EQ(faultLayer().living(), 0) << faultLayer().describeLiving();
  }
}

TEST(FaultsOfDrivers, ADeviceThatLacksSomethingSaysSoBeforeItIsOpenedAndThen) {
  faultLayer();
  VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.apiVersion = vulkanNeeds().apiVersion;
  VkInstanceCreateInfo info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pApplicationInfo = &application;
  VkInstance instance = VK_NULL_HANDLE;
  ASSERT_EQ(vkCreateInstance(&info, nullptr, &instance), VK_SUCCESS);
  std::uint32_t one = 1;
  VkPhysicalDevice device = VK_NULL_HANDLE;
  ASSERT_GE(vkEnumeratePhysicalDevices(instance, &one, &device), VK_SUCCESS);
  EXPECT_EQ(whatIsMissing(instance, device), "");
  faultLayer().hideExtension("VK_KHR_push_descriptor");
  const std::string sentence = whatIsMissing(instance, device);
  EXPECT_NE(sentence.find("lacks VK_KHR_push_descriptor; update its driver"), std::string::npos)
      << sentence;
  EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  try {
    const Renderer renderer;
    ADD_FAILURE() << "opened without it";
  } catch (const Error& error) {
    EXPECT_EQ(error.what(), sentence);
  }
  faultLayer().hideExtension(nullptr);
  vkDestroyInstance(instance, nullptr);
}

class FaultsOfMemory : public Faults {};

TEST_P(FaultsOfMemory, SceneAndPictureComeOutAfterwards) {
  Renderer renderer;
  renderer.setScene(litBall());
  const std::vector<float> expected = picture(renderer);
  const auto run = [&] {
    renderer.setScene(litBall());
    EXPECT_EQ(picture(renderer), expected);
  };
  failEachCall(199, run, [&](bool) {
    renderer.setScene(litBall());
    EXPECT_EQ(picture(renderer), expected);
  });
}

TEST_P(FaultsOfMemory, EditsComeOutAfterwards) {
  Renderer renderer;
  renderer.setScene(litBall());
  RenderOptions larger = tinyOptions();
  larger.width = 20;
  View view(renderer, tinyOptions());
  const std::vector<Vec3> rest = litBall().objects[0].mesh.positionsMm;
  std::vector<Vec3> moved = rest;
  for (Vec3& position : moved) position[1] *= 0.7F;
  const auto edit = [&](bool there) {
    renderer.replacePositions(0, there ? moved : rest);
    renderer.setMedium(0, there ? skin() : marble());
    Lighting lighting = litBall().lighting;
    if (there) lighting.points.push_back({{0, 20, 0}, {50, 100, 100}});
    renderer.setLighting(lighting);
    renderer.setTime({.seconds = there ? 0.3 : 0.0});
    view.setOptions(there ? larger : tinyOptions());
  };
  const auto shown = [&] { return view.render().images.at(0).rgba; };
  edit(true);
  const std::vector<float> expected = shown();
  edit(false);
  shown();
  bool edited = false;
  const auto run = [&] {
    edited = false;
    edit(true);
    edited = true;
    EXPECT_EQ(shown(), expected);
  };
  failEachCall(101, run, [&](bool) {
    if (!edited) edit(true);
    EXPECT_EQ(shown(), expected);
    edit(false);
    shown();
  });
}

// The device draws one frame while the next is prepared.
TEST_P(FaultsOfMemory, FramesUnderWayAreNotLost) {
  Renderer renderer;
  renderer.setScene(litBall());
  const std::vector<float> expected = picture(renderer);
  View view(renderer, tinyOptions());
  int under = 0;
  const auto run = [&] {
    view.submit();
    ++under;
    view.submit();
    ++under;
  };
  failEachCall(1, run, [&](bool) {
    for (; under > 0; --under) {
      Frame frame;
      view.collect(frame);
      EXPECT_EQ(frame.images.at(0).rgba, expected);
    }
    EXPECT_EQ(view.render().images.at(0).rgba, expected);
  });
}

class FaultsOfDevice : public Faults {};

TEST_P(FaultsOfDevice, ALostDeviceSaysSoUntilItIsClosed) {
  const auto run = [] {
    Renderer renderer;
    const bool rendered = succeeds([&] {
      renderer.setScene(litBall());
      picture(renderer);
    });
    if (rendered) return;
    EXPECT_FALSE(succeeds([&] {
      renderer.setScene(litBall());
      picture(renderer);
    }));
    throw Error("lost");
  };
  failEachCall(149, run,
               [](bool) { EXPECT_EQ(faultLayer().living(), 0) << faultLayer().describeLiving(); });
}

class FaultsOfTime : public Faults {};

TEST_P(FaultsOfTime, AWaitThatEndsEarlyIsGoneOnWith) {
  Renderer renderer;
  renderer.setScene(litBall());
  const std::vector<float> expected = picture(renderer);
  failEachCall(
      1, [&] { EXPECT_EQ(picture(renderer), expected); },
      [](bool succeeded) { EXPECT_TRUE(succeeded); });
}

std::string nameOf(const testing::TestParamInfo<VkResult>& info) {
  switch (info.param) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
      return "hostMemory";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
      return "deviceMemory";
    case VK_ERROR_DEVICE_LOST:
      return "deviceLost";
    case VK_ERROR_INITIALIZATION_FAILED:
      return "initialization";
    case VK_ERROR_MEMORY_MAP_FAILED:
      return "mapping";
    default:
      return "timeout";
  }
}

INSTANTIATE_TEST_SUITE_P(, Faults,
                         testing::Values(VK_ERROR_OUT_OF_HOST_MEMORY, VK_ERROR_DEVICE_LOST,
                                         VK_ERROR_INITIALIZATION_FAILED),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(, FaultsOfMemory,
                         testing::Values(VK_ERROR_OUT_OF_HOST_MEMORY, VK_ERROR_OUT_OF_DEVICE_MEMORY,
                                         VK_ERROR_MEMORY_MAP_FAILED),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(, FaultsOfDevice, testing::Values(VK_ERROR_DEVICE_LOST), nameOf);
INSTANTIATE_TEST_SUITE_P(, FaultsOfTime, testing::Values(VK_TIMEOUT), nameOf);

}  // namespace
}  // namespace opaline
