#include "viewer/window/queue_watch.h"

#include "viewer/window/vulkan_check.h"

namespace opaline::app::viewer {

namespace {

constexpr const char* attempt = "watch the device";

}  // namespace

QueueWatch::QueueWatch(const VulkanDevice& device) : device_(device) {
  VkFenceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
  info.flags = VK_FENCE_CREATE_SIGNALED_BIT;
  check(vkCreateFence(device_.device, &info, nullptr, &done_), attempt);
}

QueueWatch::~QueueWatch() {
  vkWaitForFences(device_.device, 1, &done_, VK_TRUE, UINT64_MAX);
  vkDestroyFence(device_.device, done_, nullptr);
}

void QueueWatch::begin() {
  check(vkWaitForFences(device_.device, 1, &done_, VK_TRUE, UINT64_MAX), attempt);
  check(vkResetFences(device_.device, 1, &done_), attempt);
  // Of no work of its own, so signalled when all before it is done.
  check(vkQueueSubmit(device_.queue, 0, nullptr, done_), attempt);
}

bool QueueWatch::isDone() const {
  // An error is for whoever waits next to find.
  return vkGetFenceStatus(device_.device, done_) != VK_NOT_READY;
}

}  // namespace opaline::app::viewer
