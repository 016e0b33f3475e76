#include <vulkan/vulkan.h>
// Included first: with Vulkan's header the C interface declares more.
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "c_interface/handles.h"
#include "c_interface/status.h"
#include "c_interface/values.h"
#include "opaline/vulkan.h"

namespace opaline::c {

template <>
inline constexpr std::size_t firstSize<OpalineDeviceTarget> = 32;
template <>
inline constexpr std::size_t firstSize<OpalineDeviceFrame> = 96;

namespace {

// More than any frame has. A larger count is a mistake, which is noticed before the array is read.
constexpr std::size_t mostParts = 65536;

std::vector<TimelinePoint> pointsOf(const OpalineTimelinePoint* points, std::size_t count,
                                    const char* name) {
  std::vector<TimelinePoint> made;
  forEachOf(points, count, mostParts, name, [&](const OpalineTimelinePoint& point) {
    made.push_back({point.semaphore, point.value});
  });
  return made;
}

DeviceTarget targetOf(const OpalineDeviceTarget* given, const char* name) {
  const OpalineDeviceTarget whole = wholeOf(given, {}, name);
  return {whole.image, whole.view, whole.format, whole.layout,
          static_cast<VkSampleCountFlagBits>(std::max(whole.samples, 1U))};
}

// A frame as it was given, with copies of what it points to.
class DeviceFrame {
 public:
  explicit DeviceFrame(const OpalineDeviceFrame* given) : given_(wholeOf(given, {}, "frame")) {
    waits = pointsOf(given_.waits, given_.waitCount, "waits");
    signals = pointsOf(given_.signals, given_.signalCount, "signals");
    forEachOf(given_.exitances, given_.exitanceCount, mostParts, "exitances",
              [&](const OpalineDeviceExitance& exitance) {
                exitances_.push_back({exitance.object, exitance.buffer, exitance.offsetBytes});
              });
    if (given_.over) compose(wholeOf(given_.over, {}, "over"));
    order = orderOf(aovsOf(given_.aovs, given_.aovCount), given_.reuseLight, given_.impatient);
    order.aovsOnDevice = aovsOf(given_.aovsOnDevice, given_.aovOnDeviceCount);
    order.onDevice = given_.onDevice != 0;
    order.exitance = given_.exitance != 0;
  }

  const OpalineDeviceFrame& given() const { return given_; }
  DeviceOutputs outputs() const {
    return {.over = composition_ ? &*composition_ : nullptr, .exitances = exitances_};
  }

  std::vector<TimelinePoint> waits;
  std::vector<TimelinePoint> signals;
  FrameOrder order;

 private:
  void compose(const OpalineComposition& over) {
    composition_.emplace();
    composition_->color = targetOf(over.color, "color");
    if (over.depth) composition_->depth = targetOf(over.depth, "depth");
    composition_->radianceScale = over.radianceScale;
  }

  OpalineDeviceFrame given_;
  std::vector<DeviceExitance> exitances_;
  std::optional<Composition> composition_;
};

void replacePositions(OpalineRenderer* renderer, std::size_t object,
                      const OpalineDevicePositions* positions, bool live) {
  const OpalineDevicePositions whole = wholeOf(positions, {}, "positions");
  required(renderer, "renderer")
      .renderer.replacePositions(
          object, DevicePositions{.buffer = whole.buffer,
                                  .offsetBytes = whole.offsetBytes,
                                  .strideBytes = whole.strideBytes == 0 ? 12 : whole.strideBytes,
                                  .live = live});
}

void giveImage(const DeviceImage& made, OpalineDeviceImage* to) {
  give({.size = 0,
        .image = made.image,
        .view = made.view,
        .format = made.format,
        .layout = made.layout,
        .width = made.extent.width,
        .height = made.extent.height},
       to, "image");
}

}  // namespace

Given givenOf(const OpalineGivenVulkan& from) {
  const OpalineGivenVulkan whole = wholeOf(&from, {}, "given");
  stringsOf(whole.enabledExtensions, whole.enabledExtensionCount, "enabledExtensions");
  GivenVulkan given{.instance = whole.instance,
                    .physicalDevice = whole.physicalDevice,
                    .device = whole.device,
                    .queueFamily = whole.queueFamily,
                    .queue = whole.queue,
                    .getInstanceProcAddr = whole.getInstanceProcAddr,
                    .enabledExtensions = {whole.enabledExtensions, whole.enabledExtensionCount},
                    .enabledFeatures = whole.enabledFeatures};
  if (whole.lockQueue)
    given.lockQueue = [call = whole.lockQueue, context = whole.lockContext] { call(context); };
  if (whole.unlockQueue)
    given.unlockQueue = [call = whole.unlockQueue, context = whole.lockContext] { call(context); };
  return given;
}

}  // namespace opaline::c

using namespace opaline;
using opaline::c::guarded;
using opaline::c::required;

extern "C" {

OpalineStatus opalineVulkanNeeds(OpalineVulkanNeeds* needs) {
  return guarded([&] {
    const VulkanNeeds& ours = vulkanNeeds();
    c::give({.size = 0,
             .apiVersion = ours.apiVersion,
             .requiredExtensions = ours.requiredExtensions.data(),
             .requiredExtensionCount = ours.requiredExtensions.size(),
             .optionalExtensions = ours.optionalExtensions.data(),
             .optionalExtensionCount = ours.optionalExtensions.size(),
             .requiredFeatures = ours.requiredFeatures,
             .optionalFeatures = ours.optionalFeatures},
            needs, "needs");
  });
}

OpalineStatus opalineWhatIsMissing(VkInstance instance, VkPhysicalDevice physicalDevice,
                                   char* sentence, size_t sentenceBytes) {
  return guarded([&] {
    c::give(whatIsMissing(instance, physicalDevice), sentence, sentenceBytes, "sentence");
  });
}

OpalineStatus opalineSetDevicePositions(OpalineRenderer* renderer, size_t object,
                                        const OpalineDevicePositions* positions) {
  return guarded([&] { c::replacePositions(renderer, object, positions, true); });
}

OpalineStatus opalineSetStillDevicePositions(OpalineRenderer* renderer, size_t object,
                                             const OpalineDevicePositions* positions) {
  return guarded([&] { c::replacePositions(renderer, object, positions, false); });
}

OpalineStatus opalineVulkanDevice(const OpalineRenderer* renderer, OpalineVulkanDevice* device) {
  return guarded([&] {
    const VulkanDevice of = required(renderer, "renderer").renderer.vulkanDevice();
    c::give({.size = 0,
             .instance = of.instance,
             .physicalDevice = of.physicalDevice,
             .device = of.device,
             .queueFamily = of.queueFamily,
             .queue = of.queue},
            device, "device");
  });
}

OpalineStatus opalinePrepareFrame(OpalineView* view, const OpalineDeviceFrame* frame) {
  return guarded([&] {
    const c::DeviceFrame whole(frame);
    c::changing(view).prepare(whole.order);
  });
}

OpalineStatus opalineSubmitFrame(OpalineView* view, const OpalineDeviceFrame* frame) {
  return guarded([&] {
    const c::DeviceFrame whole(frame);
    c::changing(view).submit(
        FrameSubmission{.waits = whole.waits, .signals = whole.signals, .outputs = whole.outputs()},
        whole.order);
  });
}

OpalineStatus opalineRecordFrame(OpalineView* view, const OpalineDeviceFrame* frame) {
  return guarded([&] {
    const c::DeviceFrame whole(frame);
    if (!whole.waits.empty()) throw UsageError("Who submits a recorded frame gives its waits.");
    if (whole.signals.size() != 1)
      throw UsageError("A recorded frame has one signal: the point that its submission signals.");
    c::changing(view).record(FrameRecording{.commands = whole.given().commands,
                                            .finished = whole.signals[0],
                                            .outputs = whole.outputs()},
                             whole.order);
  });
}

OpalineStatus opalineViewPicture(const OpalineView* view, OpalineDeviceImage* picture) {
  return guarded([&] { c::giveImage(required(view, "view").view.picture(), picture); });
}

OpalineStatus opalineViewVariable(const OpalineView* view, OpalineAov aov,
                                  OpalineDeviceImage* variable) {
  return guarded(
      [&] { c::giveImage(required(view, "view").view.picture(c::aovOf(aov)), variable); });
}

OpalineStatus opalineViewExitance(const OpalineView* view, size_t object,
                                  OpalineDeviceBuffer* exitance) {
  return guarded([&] {
    const DeviceBuffer made = required(view, "view").view.exitance(object);
    c::give(
        {.size = 0, .buffer = made.buffer, .offsetBytes = made.offsetBytes, .bytes = made.bytes},
        exitance, "exitance");
  });
}

}  // extern "C"
