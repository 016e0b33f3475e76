#include "gpu/submissions.h"

#include <algorithm>
#include <cassert>

#include "gpu/vulkan_functions.h"
#include "gpu/vulkan_result.h"
#include "opaline/error.h"

namespace opaline::gpu {

Submissions::Submissions() {
  constexpr std::size_t mostOfMany = 256;  // set-up submits more than a hundred at once
  unfinished_.reserve(mostOfMany);
}

std::uint64_t Submissions::add(const SemaphoreValue& done, By by) {
  unfinished_.push_back({++last_, done, by});
  return last_;
}

std::uint64_t Submissions::finished(const DeviceFunctions& vk, VkDevice device) {
  // Most points have the same semaphore, which need not be queried twice.
  SemaphoreValue known;
  const auto isOver = [&](const Point& point) {
    if (point.done.semaphore != known.semaphore) {
      known.semaphore = point.done.semaphore;
      if (vk.vkGetSemaphoreCounterValue(device, known.semaphore, &known.value) < 0) return false;
    }
    return known.value >= point.done.value;
  };
  unfinished_.erase(unfinished_.begin(),
                    std::find_if_not(unfinished_.begin(), unfinished_.end(), isOver));
  return unfinished_.empty() ? last_ : unfinished_.front().number - 1;
}

VkResult Submissions::tryWaitFor(std::uint64_t number, const DeviceFunctions& vk, VkDevice device) {
  assert(number <= last_);
  constexpr std::uint64_t minute = 60'000'000'000;  // ns
  while (!unfinished_.empty() && unfinished_.front().number <= number) {
    const Point& point = unfinished_.front();
    VkSemaphoreWaitInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO;
    info.semaphoreCount = 1;
    info.pSemaphores = &point.done.semaphore;
    info.pValues = &point.done.value;
    const VkResult result =
        vk.vkWaitSemaphores(device, &info, point.by == By::Others ? minute : UINT64_MAX);
    // Some drivers end even the longest wait early.
    if (result == VK_TIMEOUT && point.by == By::Device) continue;
    if (result != VK_SUCCESS) return result;
    unfinished_.erase(unfinished_.begin());
  }
  return VK_SUCCESS;
}

void Submissions::waitFor(std::uint64_t number, const DeviceFunctions& vk, VkDevice device) {
  const VkResult result = tryWaitFor(number, vk, device);
  if (result == VK_TIMEOUT)
    throw Error(
        "a frame that was recorded has not finished in a minute; submit it, and let the submission "
        "signal FrameRecording::finished");
  check(result, "wait for the device");
}

}  // namespace opaline::gpu
