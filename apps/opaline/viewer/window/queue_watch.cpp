#include "viewer/window/queue_watch.h"

#include "viewer/window/vulkan_check.h"

namespace opaline::app::viewer {

namespace {

constexpr const char* watching = "watch the device";

}  // namespace

QueueWatch::QueueWatch(const VulkanDevice& device) : device_(device) {
  VkFenceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
  info.flags = VK_FENCE_CREATE_SIGNALED_BIT;
  check(vkCreateFence(device_.device, &info, nullptr, &done_), watching);
}

QueueWatch::~QueueWatch() {
  vkWaitForFences(device_.device, 1, &done_, VK_TRUE, UINT64_MAX);
  vkDestroyFence(device_.device, done_, nullptr);
}

void QueueWatch::begin() {
  check(vkWaitForFences(device_.device, 1, &done_, VK_TRUE, UINT64_MAX), watching);
  check(vkResetFences(device_.device, 1, &done_), watching);
  // The submission is empty, so its fence is signalled when all work before it is done.
  check(vkQueueSubmit(device_.queue, 0, nullptr, done_), watching);
}

bool QueueWatch::isDone() const {
  // An error counts as done; whoever waits next will find it.
  return vkGetFenceStatus(device_.device, done_) != VK_NOT_READY;
}

}  // namespace opaline::app::viewer
