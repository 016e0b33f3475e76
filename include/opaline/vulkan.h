#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>

namespace opaline {

/// The Vulkan objects a renderer works with, for callers who fill buffers of its device. They live
/// as long as the renderer. Work on the queue is submitted from the renderer's thread.
struct VulkanDevice {
  VkInstance instance = VK_NULL_HANDLE;
  VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  std::uint32_t queueFamily = 0;
  VkQueue queue = VK_NULL_HANDLE;
};

/// Positions in mm, three floats each, of an object's vertices in their order. The buffer has the
/// usage VK_BUFFER_USAGE_STORAGE_BUFFER_BIT and lives until every frame that reads it was
/// collected. What writes it goes to the same queue before the frame and makes its writes available
/// to shader storage reads of compute shaders; what writes it again waits, by a barrier from
/// compute shaders' reads or until the frame was collected. For a vertex whose position is not
/// finite, or 1e18 mm away, the pose stands that it would have without.
struct DevicePositions {
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceSize offsetBytes = 0;    ///< multiple of 4
  std::uint32_t strideBytes = 12;  ///< from one position to the next, multiple of 4, at least 12
  bool live = true;                ///< may change at any time; false: only before another call of
                     ///< Renderer::replacePositions, so that RenderOptions::reuseLight still works
};

/// Radiance times coverage in RGB, coverage in alpha, linear, top row first; to be sampled by
/// shaders on the renderer's queue. The next frame of its kind, from whichever call, waits for
/// shaders that read it, and overwrites it; frames of another size, transport, sum, site, pattern,
/// roughness or shadow size are of another kind. It lives until the renderer has made frames of two
/// kinds besides, whatever the scene: two pictures may be shown side by side.
struct DeviceImage {
  VkImage image = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  VkExtent2D extent{};
};

}  // namespace opaline
