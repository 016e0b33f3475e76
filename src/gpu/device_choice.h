#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gpu/device.h"

namespace opaline::gpu {

struct InstanceFunctions;

/// Name, driver and type of a device, and what it lacks.
DeviceInfo describe(const InstanceFunctions& vk, VkPhysicalDevice physical, std::uint32_t index);

/// The message about a device that lacks something.
std::string unfitMessage(const DeviceInfo& device);

/// The most storage buffers of a shader, which cmake/shader_interface.py checks, and of a pipeline,
/// which asserts it.
constexpr std::uint32_t storageBuffersOfStage = 16;
/// The same if tables are read as storage (ShaderVariant).
constexpr std::uint32_t storageBuffersForTexels = 24;

/// What a device's limits and its formats' features (`featuresOf`) lack; empty if nothing.
std::string lackOfRoom(const VkPhysicalDeviceLimits& limits);
std::string lackOfFormats(const std::function<VkFormatFeatureFlags(VkFormat)>& featuresOf);

/// Whether a device has enough storage buffers to read tables as storage.
bool hasRoomForTexels(const VkPhysicalDeviceLimits& limits);

/// A queue family that does graphics and compute (and so transfer).
std::optional<std::uint32_t> findQueueFamily(const InstanceFunctions& vk,
                                             VkPhysicalDevice physical);
bool isQueueFamilyFit(const InstanceFunctions& vk, VkPhysicalDevice physical, std::uint32_t family);

/// The device that `selector` asks for (see DeviceOptions). Throws Error when there is none or it
/// lacks something, UsageError when the selector fits none.
std::size_t choose(const std::vector<DeviceInfo>& devices, const std::string& selector);

}  // namespace opaline::gpu
