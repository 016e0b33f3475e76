#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gpu/device.h"

namespace opaline::gpu {

/// Name, driver and type of a device, and what it lacks.
DeviceInfo describe(VkPhysicalDevice physical, std::uint32_t index);

/// A queue family that does graphics and compute (and so transfer).
std::optional<std::uint32_t> findQueueFamily(VkPhysicalDevice physical);

/// The device that `selector` asks for (see DeviceOptions). Throws Error when there is none or it
/// lacks something, UsageError when the selector fits none.
std::size_t choose(const std::vector<DeviceInfo>& devices, const std::string& selector);

/// The features that Opaline turns on, chained for vkCreateDevice. Not movable: it points at
/// itself.
struct Features {
  Features();
  Features(const Features&) = delete;
  Features& operator=(const Features&) = delete;

  VkPhysicalDeviceFeatures2 base{};
  VkPhysicalDeviceVulkan13Features vulkan13{};
};

}  // namespace opaline::gpu
