#include <gtest/gtest.h>

#include <cstring>
#include <thread>
#include <vector>

#include "given/engine_fixture.h"
#include "opaline/error.h"

namespace opaline::test {
namespace {

using GivenDeviceTest = EngineTest;

std::string complaintAbout(const GivenVulkan& given) {
  try {
    const Renderer renderer({.given = given});
  } catch (const UsageError& error) {
    return error.what();
  }
  return {};
}

TEST_F(GivenDeviceTest, NeedsSayWhatADeviceIsMadeWith) {
  const VulkanNeeds& needs = vulkanNeeds();
  EXPECT_EQ(needs.apiVersion, VK_API_VERSION_1_3);
  ASSERT_NE(needs.requiredFeatures, nullptr);
  ASSERT_NE(needs.optionalFeatures, nullptr);
  EXPECT_EQ(needs.requiredFeatures->sType, VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2);
  EXPECT_EQ(needs.optionalFeatures->sType, VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2);
  EXPECT_EQ(needs.optionalExtensions.size(), 3U);
  EXPECT_EQ(whatIsMissing(engine().instance(), engine().physicalDevice()), "");
}

TEST_F(GivenDeviceTest, MakesThePictureOfADeviceOfItsOwnAndDestroysNothing) {
  const Scene scene = wobblyBall();
  const std::vector<Aov> aovs{Aov::Radiance, Aov::Exitance, Aov::Depth};
  const std::vector<Image> expected = alone(scene, tinyOptions(), aovs);
  for (int round = 0; round < 2; ++round) {  // the second on what the first has left
    Renderer renderer(engine().options());
    EXPECT_EQ(renderer.vulkanDevice().device, engine().device());
    renderer.setScene(scene);
    expectSame(renderer.render(tinyOptions(), aovs).images, expected);
    EXPECT_GT(renderer.memoryBytes(), 0U);
  }
  EXPECT_EQ(Engine::waitsForIdle(), 0);
  EXPECT_EQ(engine().locks(), Engine::submissions());
  EXPECT_GT(engine().locks(), 0);
}

TEST_F(GivenDeviceTest, RefusesWhatIsNotWhole) {
  const GivenVulkan whole = engine().given();
  GivenVulkan given = whole;
  given.queue = VK_NULL_HANDLE;
  EXPECT_NE(complaintAbout(given).find("queue"), std::string::npos);
  given = whole;
  given.enabledExtensions = {};
  EXPECT_NE(complaintAbout(given).find("VK_KHR_push_descriptor"), std::string::npos);
  given = whole;
  given.unlockQueue = nullptr;
  EXPECT_NE(complaintAbout(given).find("unlockQueue"), std::string::npos);
  given = whole;
  given.queueFamily = 7;
  EXPECT_NE(complaintAbout(given).find("family"), std::string::npos);
  given = whole;
  given.enabledFeatures = nullptr;
  EXPECT_NE(complaintAbout(given).find("enabledFeatures"), std::string::npos);
  EXPECT_THROW(Renderer({.validation = true, .given = whole}), UsageError);
  EXPECT_THROW(Renderer({.rayQueries = true, .given = whole}), UsageError);
}

// Structures of Vulkan versions and of single extensions turn on the same features.
TEST_F(GivenDeviceTest, FindsFeaturesInWhicheverStructureHasThem) {
  VkPhysicalDeviceVulkan12Features of12{};
  of12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
  of12.timelineSemaphore = VK_TRUE;
  VkPhysicalDeviceVulkan13Features of13{};
  of13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
  of13.pNext = &of12;
  of13.dynamicRendering = of13.synchronization2 = of13.maintenance4 = VK_TRUE;
  of13.shaderDemoteToHelperInvocation = of13.shaderTerminateInvocation = VK_TRUE;
  VkPhysicalDeviceFeatures2 features{};
  features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
  features.pNext = &of13;
  features.features.imageCubeArray = features.features.independentBlend = VK_TRUE;
  GivenVulkan given = engine().given();
  given.enabledFeatures = &features;
  EXPECT_EQ(complaintAbout(given), "");
  of12.timelineSemaphore = VK_FALSE;
  features.features.imageCubeArray = VK_FALSE;
  const std::string complaint = complaintAbout(given);
  EXPECT_NE(complaint.find("imageCubeArray, timelineSemaphore"), std::string::npos) << complaint;
}

// The engine submits from a third.
TEST_F(GivenDeviceTest, RenderersOnTwoThreadsShareTheQueueUnderItsLock) {
  const Scene scene = wobblyBall();
  const std::vector<Image> expected = alone(scene, tinyOptions());
  const auto work = [&] {
    Renderer renderer(engine().options());
    for (int frame = 0; frame < 3; ++frame) {
      renderer.setScene(scene);
      expectSame(renderer.render(tinyOptions()).images, expected);
    }
  };
  std::thread first(work);
  std::thread second(work);
  for (int i = 0; i < 20; ++i) engine().run([](VkCommandBuffer) {});
  first.join();
  second.join();
}

TEST_F(GivenDeviceTest, ALostDeviceIsOneSentenceAndNothingIsLeft) {
  Renderer renderer(engine().options());
  renderer.setScene(wobblyBall());
  View view(renderer, tinyOptions());
  view.submit();
  Engine::loseDevice(true);
  Frame frame;
  const auto messageOf = [](const auto& call) {
    try {
      call();
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(messageOf([&] { view.collect(frame); }).find("device was lost"), std::string::npos);
  EXPECT_NE(messageOf([&] { view.render(); }).find("device was lost"), std::string::npos);
  Engine::loseDevice(false);  // only the calls failed: what is destroyed must not be in use
  engine().run([](VkCommandBuffer) {});
}

TEST_F(GivenDeviceTest, ThePipelineCacheComesBackWhateverItHolds) {
  const Scene scene = wobblyBall();
  std::vector<std::byte> cache;
  std::vector<Image> first;
  {
    Renderer renderer(engine().options());
    renderer.setScene(scene);
    first = renderer.render(tinyOptions()).images;
    cache = renderer.pipelineCache();
  }
  EXPECT_GT(cache.size(), 16U);
  std::vector<std::byte> damaged = cache;
  damaged.back() ^= std::byte{1};
  const std::vector<std::byte> other(100, std::byte{0x5a});
  for (const std::vector<std::byte>& given : {cache, damaged, other}) {
    RendererOptions options = engine().options();
    options.pipelineCache = given;
    Renderer renderer(options);
    renderer.setScene(scene);
    expectSame(renderer.render(tinyOptions()).images, first);
  }
}

TEST_F(GivenDeviceTest, WhatExceedsTheBudgetIsAnErrorAfterWhichTheRendererWorks) {
  RendererOptions options = engine().options();
  options.memoryLimit = 64.0F;
  Renderer renderer(options);
  renderer.setScene(wobblyBall());
  const std::vector<Image> before = renderer.render(tinyOptions()).images;
  RenderOptions large = tinyOptions();
  large.width = large.height = 4096;
  EXPECT_THROW(renderer.render(large), Error);
  EXPECT_LE(renderer.memoryBytes(), 64'000'000U);
  expectSame(renderer.render(tinyOptions()).images, before);
}

}  // namespace
}  // namespace opaline::test
