#include "viewer/window/presenting_device.h"

#include <vector>

#include "viewer/window/vulkan_check.h"
#include "viewer/window/window.h"

namespace opaline::app::viewer {

namespace {

bool isSoftware(VkPhysicalDevice device) {
  VkPhysicalDeviceProperties properties{};
  vkGetPhysicalDeviceProperties(device, &properties);
  return properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
}

}  // namespace

PresentingDevice::PresentingDevice(const VulkanDevice& renderers) : device_(renderers) {
  if (isSoftware(device_.physicalDevice)) makeOwn();
}

PresentingDevice::~PresentingDevice() {
  if (own_) vkDestroyDevice(device_.device, nullptr);
}

void PresentingDevice::makeOwn() {
  const float priority = 1;
  VkDeviceQueueCreateInfo queue{};
  queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
  queue.queueFamilyIndex = device_.queueFamily;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  std::vector<const char*> extensions{VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME};
  const std::vector<std::string> windows = Window::deviceExtensions();
  for (const std::string& extension : windows) extensions.push_back(extension.c_str());
  VkDeviceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  check(vkCreateDevice(device_.physicalDevice, &info, nullptr, &device_.device),
        "prepare its drawing");
  own_ = true;
  vkGetDeviceQueue(device_.device, device_.queueFamily, 0, &device_.queue);
}

}  // namespace opaline::app::viewer
