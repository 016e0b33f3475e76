#include "viewer/window/vulkan_objects.h"

#include "viewer/window/vulkan_check.h"

namespace opaline::app::viewer {

VkCommandPool makeCommandPool(const VulkanDevice& device, VkCommandPoolCreateFlags flags,
                              const char* attempt) {
  VkCommandPoolCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  info.flags = flags;
  info.queueFamilyIndex = device.queueFamily;
  VkCommandPool pool = VK_NULL_HANDLE;
  check(vkCreateCommandPool(device.device, &info, nullptr, &pool), attempt);
  return pool;
}

VkCommandBuffer makeCommands(VkDevice device, VkCommandPool pool, const char* attempt) {
  VkCommandBufferAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
  info.commandPool = pool;
  info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  info.commandBufferCount = 1;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  check(vkAllocateCommandBuffers(device, &info, &commands), attempt);
  return commands;
}

void beginCommands(VkCommandBuffer commands, const char* attempt) {
  VkCommandBufferBeginInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(commands, &info), attempt);
}

VkImageView makeView(VkDevice device, VkImage image, VkFormat format, const char* attempt) {
  VkImageViewCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
  info.image = image;
  info.viewType = VK_IMAGE_VIEW_TYPE_2D;
  info.format = format;
  info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  VkImageView view = VK_NULL_HANDLE;
  check(vkCreateImageView(device, &info, nullptr, &view), attempt);
  return view;
}

namespace {

/// A command pool that is destroyed once its commands have run, or on any error.
struct OnePool {
  OnePool(const VulkanDevice& owner, const char* attempt)
      : device(owner.device), handle(makeCommandPool(owner, 0, attempt)) {}
  ~OnePool() {
    vkDeviceWaitIdle(device);
    vkDestroyCommandPool(device, handle, nullptr);
  }
  OnePool(const OnePool&) = delete;
  OnePool& operator=(const OnePool&) = delete;

  VkDevice device;
  VkCommandPool handle;
};

}  // namespace

void runOnce(const VulkanDevice& device, const std::function<void(VkCommandBuffer)>& record,
             const char* attempt) {
  const OnePool pool(device, attempt);
  const VkCommandBuffer commands = makeCommands(device.device, pool.handle, attempt);
  beginCommands(commands, attempt);
  record(commands);
  check(vkEndCommandBuffer(commands), attempt);
  VkSubmitInfo submit{};
  submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &commands;
  check(vkQueueSubmit(device.queue, 1, &submit, VK_NULL_HANDLE), attempt);
  check(vkQueueWaitIdle(device.queue), attempt);
}

}  // namespace opaline::app::viewer
