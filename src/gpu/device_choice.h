#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gpu/device.h"

namespace opaline::gpu {

/// Name, driver and type of a device, and what it lacks.
DeviceInfo describe(VkPhysicalDevice physical, std::uint32_t index);

/// Most storage buffers of a pass; Pipeline asserts it of each.
constexpr std::uint32_t storageBuffersOfStage = 12;

/// What a device lacks of limits and of features of formats, which it may have by `featuresOf`;
/// empty: nothing.
std::string lackOfRoom(const VkPhysicalDeviceLimits& limits);
std::string lackOfFormats(const std::function<VkFormatFeatureFlags(VkFormat)>& featuresOf);

/// A queue family that does graphics and compute (and so transfer).
std::optional<std::uint32_t> findQueueFamily(VkPhysicalDevice physical);

/// The device that `selector` asks for (see DeviceOptions). Throws Error when there is none or it
/// lacks something, UsageError when the selector fits none.
std::size_t choose(const std::vector<DeviceInfo>& devices, const std::string& selector);

/// Extensions of the device that ray queries need.
constexpr std::array<const char*, 3> rayExtensions{VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME,
                                                   VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME,
                                                   VK_KHR_RAY_QUERY_EXTENSION_NAME};

/// The features that Opaline turns on, chained for vkCreateDevice. Not movable: it points at
/// itself.
struct Features {
  Features();
  Features(const Features&) = delete;
  Features& operator=(const Features&) = delete;

  /// Adds those of ray queries, which not every device has.
  void chainRayQueries();

  VkPhysicalDeviceFeatures2 base{};
  VkPhysicalDeviceVulkan13Features vulkan13{};
  VkPhysicalDeviceTimelineSemaphoreFeatures timeline{};
  VkPhysicalDeviceBufferDeviceAddressFeatures addresses{};
  VkPhysicalDeviceAccelerationStructureFeaturesKHR structures{};
  VkPhysicalDeviceRayQueryFeaturesKHR rayQueries{};
};

}  // namespace opaline::gpu
