#include "caller.h"

#include <algorithm>

#include "opaline/error.h"

namespace opaline::bench {

namespace {

void check(VkResult result) {
  if (result < 0) throw Error("the caller's work on the device failed");
}

}  // namespace

Caller::Caller(const Renderer& renderer) : vulkan_(renderer.vulkanDevice()) {
  VkSemaphoreTypeCreateInfo type{};
  type.sType = VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO;
  type.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE;
  VkSemaphoreCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
  info.pNext = &type;
  check(vkCreateSemaphore(vulkan_.device, &info, nullptr, &timeline_));
  for (std::size_t i = 0; i < pools_.size(); ++i) {
    VkCommandPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    pool.queueFamilyIndex = vulkan_.queueFamily;
    check(vkCreateCommandPool(vulkan_.device, &pool, nullptr, &pools_[i]));
    VkCommandBufferAllocateInfo buffer{};
    buffer.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    buffer.commandPool = pools_[i];
    buffer.commandBufferCount = 1;
    check(vkAllocateCommandBuffers(vulkan_.device, &buffer, &buffers_[i]));
  }
}

Caller::~Caller() {
  vkDeviceWaitIdle(vulkan_.device);
  for (const VkCommandPool pool : pools_) vkDestroyCommandPool(vulkan_.device, pool, nullptr);
  vkDestroySemaphore(vulkan_.device, timeline_, nullptr);
}

FrameRecording Caller::begin() {
  const std::size_t slot = frames_ % pools_.size();
  const std::uint64_t before = std::max<std::uint64_t>(frames_, 1) - 1;
  VkSemaphoreWaitInfo wait{};
  wait.sType = VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO;
  wait.semaphoreCount = 1;
  wait.pSemaphores = &timeline_;
  wait.pValues = &before;
  check(vkWaitSemaphores(vulkan_.device, &wait, UINT64_MAX));
  check(vkResetCommandPool(vulkan_.device, pools_[slot], 0));
  VkCommandBufferBeginInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(buffers_[slot], &info));
  return {.commands = buffers_[slot], .finished = {timeline_, ++frames_}};
}

void Caller::submit(const FrameRecording& recording) {
  check(vkEndCommandBuffer(recording.commands));
  VkCommandBufferSubmitInfo buffer{};
  buffer.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
  buffer.commandBuffer = recording.commands;
  VkSemaphoreSubmitInfo signal{};
  signal.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO;
  signal.semaphore = recording.finished.semaphore;
  signal.value = recording.finished.value;
  signal.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  VkSubmitInfo2 info{};
  info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
  info.commandBufferInfoCount = 1;
  info.pCommandBufferInfos = &buffer;
  info.signalSemaphoreInfoCount = 1;
  info.pSignalSemaphoreInfos = &signal;
  check(vkQueueSubmit2(vulkan_.queue, 1, &info, VK_NULL_HANDLE));
}

}  // namespace opaline::bench
