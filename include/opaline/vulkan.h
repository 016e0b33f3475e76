#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>

namespace opaline {

/// The Vulkan objects of a renderer, for callers who fill buffers of its device. They live as long
/// as the renderer. Submit work on the queue from the renderer's thread.
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
