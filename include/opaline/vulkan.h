#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "opaline/export.h"

namespace opaline {

/// What the library needs of a Vulkan device, to be merged into what a caller asks of its own.
struct VulkanNeeds {
  std::uint32_t apiVersion = 0;                     ///< of instance and device, at least
  std::span<const char* const> requiredExtensions;  ///< of the device
  std::span<const char* const> optionalExtensions;  ///< all of them, or none, for ray queries
  /// Features that are VK_TRUE in this chain have to be enabled.
  const VkPhysicalDeviceFeatures2* requiredFeatures = nullptr;
  /// The same of what goes with the optional extensions. Both chains have different structures.
  const VkPhysicalDeviceFeatures2* optionalFeatures = nullptr;
};

/// Lives as long as the process. May be called from any thread.
OPALINE_API const VulkanNeeds& vulkanNeeds();

/// Why the library cannot use the device, in one sentence; empty if it can. The instance is for
/// Vulkan 1.3. May be called from any thread.
OPALINE_API std::string whatIsMissing(VkInstance instance, VkPhysicalDevice physicalDevice);

/// A device of the caller's, for RendererOptions::given. It has what vulkanNeeds() requires, of an
/// instance for Vulkan 1.3. The library destroys nothing of it, and it outlives every renderer that
/// works on it, of which there may be several, each on a thread of its own. Extensions and features
/// are only read while a renderer is made.
struct GivenVulkan {
  VkInstance instance = VK_NULL_HANDLE;
  VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  std::uint32_t queueFamily = 0;   ///< does graphics and compute
  VkQueue queue = VK_NULL_HANDLE;  ///< of that family; all work of the renderer goes there
  /// All functions are loaded by it; null: by the Vulkan loader that the library is linked with.
  PFN_vkGetInstanceProcAddr getInstanceProcAddr = nullptr;
  std::span<const char* const> enabledExtensions;  ///< of the device
  /// What the device was made with, chained as there, whether by structures of Vulkan versions or
  /// of single extensions.
  const VkPhysicalDeviceFeatures2* enabledFeatures = nullptr;
  /// Called before and after each submission to the queue; needed where others use the queue from
  /// other threads. The lock is never held while the library waits for the device.
  std::function<void()> lockQueue;
  std::function<void()> unlockQueue;
};

/// A value of a timeline semaphore of the caller's.
struct TimelinePoint {
  VkSemaphore semaphore = VK_NULL_HANDLE;
  std::uint64_t value = 0;
};

/// The Vulkan objects of a renderer, for callers who fill buffers of its device. They live as long
/// as the renderer, or as their owner lets them if the device was given. Submit work on the queue
/// from the renderer's thread, or under the lock of a given device.
struct VulkanDevice {
  VkInstance instance = VK_NULL_HANDLE;
  VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  std::uint32_t queueFamily = 0;
  VkQueue queue = VK_NULL_HANDLE;
};

/// Positions in mm, three floats each, of an object's vertices in their order. The buffer has the
/// usage VK_BUFFER_USAGE_STORAGE_BUFFER_BIT and lives until every frame that reads it has been
/// collected. Writes to it are submitted to the same queue before the frame, and are made available
/// to storage reads of compute shaders. A later write waits for these reads, by a barrier or until
/// the frame has been collected. A vertex whose position is not finite, or 1e18 mm away, keeps the
/// position that it would have without the buffer.
struct DevicePositions {
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceSize offsetBytes = 0;    ///< multiple of 4
  std::uint32_t strideBytes = 12;  ///< from one position to the next, multiple of 4, at least 12
  bool live = true;                ///< may change at any time; false: only before another call of
                     ///< Renderer::replacePositions, so that FrameOrder::reuseLight still works
};

/// Radiance times coverage in RGB, coverage in alpha, linear, top row first. Shaders on the
/// renderer's queue may sample it. The view's next frame waits for shaders that read it, and
/// overwrites it. The image lives until the view gets another size or goes away, whatever the
/// scene. Work that uses it and was submitted before that is waited for.
struct DeviceImage {
  VkImage image = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  VkExtent2D extent{};
};

}  // namespace opaline
