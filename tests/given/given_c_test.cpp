// The C interface on a caller's device. Vulkan's header comes first, so that ours declares that
// part.
#include <vulkan/vulkan.h>

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <vector>

#include "given/engine_fixture.h"
#include "opaline/opaline_c.h"

namespace opaline::test {
namespace {

using GivenCTest = EngineTest;

template <typename Handle, void (*destroy)(Handle*)>
struct Destroy {
  void operator()(Handle* handle) const { destroy(handle); }
};
template <typename Handle, void (*destroy)(Handle*)>
using Owned = std::unique_ptr<Handle, Destroy<Handle, destroy>>;

OpalineGivenVulkan givenInC(const GivenVulkan& given, Engine& engine) {
  OpalineGivenVulkan made{};
  made.size = sizeof made;
  made.instance = given.instance;
  made.physicalDevice = given.physicalDevice;
  made.device = given.device;
  made.queueFamily = given.queueFamily;
  made.queue = given.queue;
  made.getInstanceProcAddr = given.getInstanceProcAddr;
  made.enabledExtensions = given.enabledExtensions.data();
  made.enabledExtensionCount = given.enabledExtensions.size();
  made.enabledFeatures = given.enabledFeatures;
  made.lockContext = &engine;
  made.lockQueue = [](void* context) { static_cast<Engine*>(context)->given().lockQueue(); };
  made.unlockQueue = [](void* context) { static_cast<Engine*>(context)->given().unlockQueue(); };
  return made;
}

using OwnedRenderer = Owned<OpalineRenderer, opalineDestroyRenderer>;

/// On the caller's device, with the scene.
void makeRenderer(const OpalineGivenVulkan& given, const OpalineScene* scene, OwnedRenderer& made) {
  OpalineRendererOptions options{};
  options.size = sizeof options;
  ASSERT_EQ(opalineDefaultRendererOptions(&options), OpalineOk);
  options.given = &given;
  OpalineRenderer* renderer = nullptr;
  ASSERT_EQ(opalineCreateRenderer(&options, &renderer), OpalineOk) << opalineLastError();
  made.reset(renderer);
  ASSERT_EQ(opalineSetScene(renderer, scene), OpalineOk);
}

void makeSmall(OpalineRenderOptions& picture) {
  picture.size = sizeof picture;
  ASSERT_EQ(opalineDefaultRenderOptions(&picture), OpalineOk);
  picture.width = picture.height = 24;
  picture.transport = OpalineTransportBetterDipole;
  picture.shadowSize = 128;
}

TEST_F(GivenCTest, NeedsAreThoseOfTheCppInterface) {
  OpalineVulkanNeeds needs{};
  needs.size = sizeof needs;
  ASSERT_EQ(opalineVulkanNeeds(&needs), OpalineOk);
  EXPECT_EQ(needs.requiredFeatures, vulkanNeeds().requiredFeatures);
  EXPECT_EQ(needs.requiredExtensionCount, vulkanNeeds().requiredExtensions.size());
  char sentence[200] = "something";
  EXPECT_EQ(opalineWhatIsMissing(engine().instance(), engine().physicalDevice(), sentence,
                                 sizeof sentence),
            OpalineOk);
  EXPECT_STREQ(sentence, "");
}

TEST_F(GivenCTest, ARecordedFrameIsTheRenderedOne) {
  OpalineScene* scene = nullptr;
  ASSERT_EQ(opalineCreateTeapot(nullptr, &scene), OpalineOk);
  const Owned<OpalineScene, opalineDestroyScene> ofScene(scene);
  const OpalineGivenVulkan given = givenInC(engine().given(), engine());
  OwnedRenderer ofRenderer;
  OpalineRenderOptions picture{};
  ASSERT_NO_FATAL_FAILURE(makeRenderer(given, scene, ofRenderer));
  ASSERT_NO_FATAL_FAILURE(makeSmall(picture));
  OpalineRenderer* const renderer = ofRenderer.get();
  picture.site = OpalineSiteVertex;
  OpalineView* view = nullptr;
  ASSERT_EQ(opalineCreateView(renderer, &picture, &view), OpalineOk);
  const Owned<OpalineView, opalineDestroyView> ofView(view);

  const OpalineAov aov = OpalineAovRadiance;
  const TimelinePoint point = engine().nextPoint();
  const OpalineTimelinePoint finished{sizeof finished, point.semaphore, point.value};
  OpalineDeviceFrame frame{};
  frame.size = sizeof frame;
  frame.signals = &finished;
  frame.signalCount = 1;
  frame.commands = engine().begin();
  frame.onDevice = frame.exitance = 1;
  frame.aovs = &aov;
  frame.aovCount = 1;
  ASSERT_EQ(opalinePrepareFrame(view, &frame), OpalineOk) << opalineLastError();
  const int before = Engine::submissions();
  ASSERT_EQ(opalineRecordFrame(view, &frame), OpalineOk) << opalineLastError();
  EXPECT_EQ(Engine::submissions(), before);
  engine().submit(frame.commands, point);
  constexpr std::size_t floats = std::size_t{4} * 24 * 24;
  std::vector<float> recorded(floats);
  std::vector<float> rendered(floats);
  const OpalineTarget ofRecorded{sizeof(OpalineTarget), aov, recorded.data(), floats};
  const OpalineTarget ofRendered{sizeof(OpalineTarget), aov, rendered.data(), floats};
  ASSERT_EQ(opalineCollect(view, &ofRecorded, 1, nullptr), OpalineOk) << opalineLastError();
  OpalineDeviceImage image{};
  image.size = sizeof image;
  EXPECT_EQ(opalineViewPicture(view, &image), OpalineOk);
  EXPECT_EQ(image.width, 24U);
  OpalineDeviceBuffer exitance{};
  exitance.size = sizeof exitance;
  EXPECT_EQ(opalineViewExitance(view, 0, &exitance), OpalineOk);
  EXPECT_GT(exitance.bytes, 0U);
  ASSERT_EQ(opalineRender(view, &ofRendered, 1), OpalineOk);
  EXPECT_EQ(recorded, rendered);

  // A frame that the library submits, and what a recorded one lacks.
  const TimelinePoint later = engine().nextPoint();
  const OpalineTimelinePoint done{sizeof done, later.semaphore, later.value};
  frame.signals = &done;
  ASSERT_EQ(opalineSubmitFrame(view, &frame), OpalineOk) << opalineLastError();
  engine().waitFor(later);
  EXPECT_EQ(opalineCollect(view, &ofRecorded, 1, nullptr), OpalineOk);
  EXPECT_EQ(recorded, rendered);
  frame.signalCount = 0;
  EXPECT_EQ(opalineRecordFrame(view, &frame), OpalineBadUse);
  OpalineVulkanDevice device{};
  device.size = sizeof device;
  ASSERT_EQ(opalineVulkanDevice(renderer, &device), OpalineOk);
  EXPECT_EQ(device.device, engine().device());
  EXPECT_EQ(device.queue, given.queue);
  uint64_t bytes = 0;
  EXPECT_EQ(opalineMemoryInUse(renderer, &bytes), OpalineOk);
  EXPECT_GT(bytes, 0U);
  std::size_t size = 0;
  ASSERT_EQ(opalinePipelineCache(renderer, nullptr, &size), OpalineOk);
  std::vector<char> cache(size);
  EXPECT_EQ(opalinePipelineCache(renderer, cache.data(), &size), OpalineOk);
}

// Light can be reused with a buffer that only changes when it is given again.
TEST_F(GivenCTest, PositionsOfABufferThatStandsStillKeepTheirLight) {
  OpalineScene* scene = nullptr;
  ASSERT_EQ(opalineCreateTeapot(nullptr, &scene), OpalineOk);
  const Owned<OpalineScene, opalineDestroyScene> ofScene(scene);
  OpalineObjectFacts facts{};
  facts.size = sizeof facts;
  ASSERT_EQ(opalineObjectFacts(scene, 0, &facts), OpalineOk);
  const std::size_t floats = 3 * facts.vertexCount;
  const Engine::HostBuffer buffer =
      engine().makeBuffer(floats * sizeof(float), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  ASSERT_EQ(
      opalineObjectPositions(scene, 0, reinterpret_cast<float*>(buffer.mapped), facts.vertexCount),
      OpalineOk);
  const OpalineGivenVulkan given = givenInC(engine().given(), engine());
  OwnedRenderer ofRenderer;
  OpalineRenderOptions picture{};
  ASSERT_NO_FATAL_FAILURE(makeRenderer(given, scene, ofRenderer));
  ASSERT_NO_FATAL_FAILURE(makeSmall(picture));
  OpalineRenderer* const renderer = ofRenderer.get();
  OpalineView* view = nullptr;
  ASSERT_EQ(opalineCreateView(renderer, &picture, &view), OpalineOk);
  const Owned<OpalineView, opalineDestroyView> ofView(view);
  OpalineDevicePositions positions{};
  positions.size = sizeof positions;
  positions.buffer = buffer.buffer;
  OpalineDeviceFrame frame{};
  frame.size = sizeof frame;
  const OpalineAov aov = OpalineAovExitance;
  frame.aovs = &aov;
  frame.aovCount = 1;
  frame.reuseLight = 1;
  std::vector<float> rgba(std::size_t{4} * 24 * 24);
  const OpalineTarget target{sizeof target, aov, rgba.data(), rgba.size()};
  OpalineFrameReport report{};
  report.size = sizeof report;
  const auto passesOfSecondFrame = [&] {
    for (int i = 0; i < 2; ++i) {
      EXPECT_EQ(opalineSubmitFrame(view, &frame), OpalineOk) << opalineLastError();
      EXPECT_EQ(opalineCollect(view, &target, 1, nullptr), OpalineOk);
    }
    EXPECT_EQ(opalineFrameReport(view, &report), OpalineOk);
    return report.passCount;
  };
  ASSERT_EQ(opalineSetDevicePositions(renderer, 0, &positions), OpalineOk);
  const std::size_t ofLive = passesOfSecondFrame();
  const std::vector<float> expected = rgba;
  ASSERT_EQ(opalineSetStillDevicePositions(renderer, 0, &positions), OpalineOk);
  EXPECT_LT(passesOfSecondFrame(), ofLive);
  EXPECT_EQ(rgba, expected);
}

TEST_F(GivenCTest, EnvironmentsComeFromMemory) {
  OpalineScene* scene = nullptr;
  ASSERT_EQ(opalineCreateTeapot(nullptr, &scene), OpalineOk);
  const Owned<OpalineScene, opalineDestroyScene> ofScene(scene);
  std::vector<float> sky(std::size_t{4} * 8 * 4, 0.5F);
  EXPECT_EQ(opalineSetEnvironmentPixels(scene, sky.data(), 8, 4, 2, 30), OpalineOk);
  sky[4] = -1;
  EXPECT_EQ(opalineSetEnvironmentPixels(scene, sky.data(), 8, 4, 2, 30), OpalineBadUse);
  EXPECT_NE(std::strstr(opalineLastError(), "pixel 1"), nullptr) << opalineLastError();
  EXPECT_EQ(opalineSetEnvironmentPixels(scene, sky.data(), 0, 4, 2, 30), OpalineBadUse);
}

}  // namespace
}  // namespace opaline::test
