#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <optional>
#include <thread>
#include <utility>
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
  const char* const none = nullptr;
  given.enabledExtensions = {&none, 1};
  EXPECT_NE(complaintAbout(given).find("enabledExtensions"), std::string::npos);
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
  EXPECT_THROW(static_cast<void>(whatIsMissing(engine().instance(), VK_NULL_HANDLE)), UsageError);
}

TEST_F(GivenDeviceTest, WhatCannotBeUsedSaysSo) {
  Renderer renderer(engine().options());
  const Renderer kept(std::move(renderer));
  EXPECT_THROW(renderer.setTime({}), UsageError);  // NOLINT(bugprone-use-after-move): its subject
  EXPECT_THROW(static_cast<void>(renderer.memoryBytes()), UsageError);
  renderer = Renderer(engine().options());
  renderer.setScene(wobblyBall());
  View view(renderer, tinyOptions());
  const TimelinePoint nowhere{VK_NULL_HANDLE, 1};
  EXPECT_THROW(view.submit({.waits = {&nowhere, 1}}, {}), UsageError);
  EXPECT_THROW(view.submit({.signals = {&nowhere, 1}}, {}), UsageError);
  const View moved(std::move(view));
  EXPECT_THROW(view.submit(), UsageError);  // NOLINT(bugprone-use-after-move)
  EXPECT_THROW(static_cast<void>(view.options()), UsageError);
}

// Structures of Vulkan versions and of single extensions enable the same features.
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

// The engine submits from a third thread. Frames of several sizes are under way when their views
// change or are destroyed; some are submitted by the library, others recorded.
TEST_F(GivenDeviceTest, ViewsOfTwoRenderersChangeAndGoWhileThreeThreadsUseTheQueue) {
  const Scene scene = wobblyBall();
  const auto work = [&] {
    Renderer renderer(engine().options());
    renderer.setScene(scene);
    std::optional<View> view;
    TimelinePoint last;
    for (int i = 0; i < 6; ++i) {
      if (i % 3 == 0) view.emplace(renderer, tinyOptions());
      RenderOptions options = tinyOptions();
      options.width = 16 + 8 * (i % 2);
      view->setOptions(options);
      renderer.setTime({.seconds = 0.1 * i});
      last = engine().nextPoint();
      const FrameOrder order{.aovs = {}, .onDevice = true};
      if (i % 4 < 2) {
        view->submit({.signals = {&last, 1}}, order);
      } else {
        const VkCommandBuffer commands = engine().begin();
        view->record({.commands = commands, .finished = last}, order);
        engine().submit(commands, last);
      }
    }
    RenderOptions plain = tinyOptions();
    view->setOptions(plain);
    Frame frame;
    view->submit();
    do view->collect(frame);
    while (frame.images.empty());
    const RenderResult alike = renderer.render(plain);
    EXPECT_EQ(frame.images[0].rgba, alike.images[0].rgba);
    view.reset();
    engine().waitFor(last);
  };
  std::thread first(work);
  std::thread second(work);
  for (int i = 0; i < 40; ++i) engine().run([](VkCommandBuffer) {});
  first.join();
  second.join();
  EXPECT_EQ(Engine::waitsForIdle(), 0);
}

// The engine submits from a third thread.
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

void expectLost(const std::function<void()>& call) {
  try {
    call();
    ADD_FAILURE() << "nothing was thrown";
  } catch (const UsageError& error) {
    ADD_FAILURE() << "counts as a mistake of the caller: " << error.what();
  } catch (const Error& error) {
    const std::string sentence = error.what();
    EXPECT_NE(sentence.find("device was lost"), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  }
}

// Only the calls fail. The device finishes its work afterwards, so that the validation layer can
// tell what is destroyed too early and what is left.
TEST_F(GivenDeviceTest, ALostDeviceIsOneSentenceAndNothingIsLeft) {
  Renderer renderer(engine().options());
  renderer.setScene(wobblyBall());
  View view(renderer, tinyOptions());
  view.submit();
  Engine::loseDevice(true);
  Frame frame;
  expectLost([&] { view.collect(frame); });
  expectLost([&] { view.render(); });
  Engine::loseDevice(false);
  engine().run([](VkCommandBuffer) {});
}

// Two frames are under way, recorded and submitted by the engine. What is left of the renderer goes
// while its calls still fail.
TEST_F(GivenDeviceTest, ADeviceLostDuringRecordedFramesIsOneSentenceAndNothingIsLeft) {
  for (const bool hasFinished : {false, true}) {
    SCOPED_TRACE(hasFinished ? "lost between frames" : "lost during frames");
    const TimelinePoint go = engine().nextPoint();
    TimelinePoint last = go;
    const auto proceed = [&] {
      engine().signal(go);
      engine().waitFor(last);
    };
    {
      Renderer renderer(engine().options());
      renderer.setScene(wobblyBall());
      View view(renderer, tinyOptions());
      const FrameOrder order{.aovs = {}, .onDevice = true};
      for (int i = 0; i < View::framesInFlight; ++i) {
        const VkCommandBuffer commands = engine().begin();
        const TimelinePoint point = engine().nextPoint();
        view.record({.commands = commands, .finished = point}, order);
        engine().submit(commands, point, {std::exchange(last, point)});
      }
      if (hasFinished) proceed();
      Engine::loseDevice(true);
      if (!hasFinished) {
        const VkCommandBuffer commands = engine().begin();
        const TimelinePoint never = engine().nextPoint();
        expectLost([&] { view.record({.commands = commands, .finished = never}, order); });
        Frame frame;
        expectLost([&] { view.collect(frame); });
      }
      RenderOptions larger = tinyOptions();
      larger.width = 48;
      view.setOptions(larger);
      expectLost([&] { view.submit(order); });
      expectLost([&] { view.render({.aovs = {Aov::Exitance}}); });
      expectLost([&] { renderer.render(tinyOptions()); });
      expectLost([&] { view.prepare(); });
      expectLost([&] { renderer.setScene(wobblyBall()); });
      if (!hasFinished) proceed();
    }
    Engine::loseDevice(false);
  }
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
