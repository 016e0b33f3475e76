#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "opaline/export.h"

namespace opaline {

/// What the library needs of a Vulkan device, to be merged with the caller's own needs.
struct VulkanNeeds {
  std::uint32_t apiVersion = 0;                     ///< of instance and device, at least
  std::span<const char* const> requiredExtensions;  ///< of the device
  std::span<const char* const> optionalExtensions;  ///< all of them, or none, for ray queries
  /// Features that are VK_TRUE in this chain have to be enabled.
  const VkPhysicalDeviceFeatures2* requiredFeatures = nullptr;
  /// The same for the optional extensions. No structure occurs in both chains.
  const VkPhysicalDeviceFeatures2* optionalFeatures = nullptr;
};

/// The result lives as long as the process. May be called from any thread.
OPALINE_API const VulkanNeeds& vulkanNeeds();

/// Why the library cannot use the device, in one sentence; empty if it can. The instance is for
/// Vulkan 1.3. May be called from any thread.
OPALINE_API std::string whatIsMissing(VkInstance instance, VkPhysicalDevice physicalDevice);

/// A device of the caller's, for RendererOptions::given. It has to meet vulkanNeeds(), with an
/// instance for Vulkan 1.3. The library destroys none of it, and it has to outlive every renderer
/// that works on it. There may be several, each on a thread of its own. Extensions and features are
/// only read while a renderer is made.
struct GivenVulkan {
  VkInstance instance = VK_NULL_HANDLE;
  VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  std::uint32_t queueFamily = 0;   ///< does graphics and compute
  VkQueue queue = VK_NULL_HANDLE;  ///< of that family; receives all work of the renderer
  /// Loads all functions; null: the Vulkan loader that the library is linked with does.
  PFN_vkGetInstanceProcAddr getInstanceProcAddr = nullptr;
  std::span<const char* const> enabledExtensions;  ///< of the device
  /// The chain of features that the device was created with. Its structures may be those of Vulkan
  /// versions or of single extensions.
  const VkPhysicalDeviceFeatures2* enabledFeatures = nullptr;
  /// Called before and after each submission to the queue. Needed if other threads use the queue.
  /// The lock is never held while the library waits for the device.
  std::function<void()> lockQueue;
  std::function<void()> unlockQueue;
};

/// A value of a timeline semaphore of the caller's.
struct TimelinePoint {
  VkSemaphore semaphore = VK_NULL_HANDLE;
  std::uint64_t value = 0;
};

/// The Vulkan objects of a renderer, for callers who fill buffers of its device. They live as long
/// as the renderer; those of a given device are its owner's. Submit work to the queue from the
/// renderer's thread, or under the lock of a given device.
struct VulkanDevice {
  VkInstance instance = VK_NULL_HANDLE;
  VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  std::uint32_t queueFamily = 0;
  VkQueue queue = VK_NULL_HANDLE;
};

/// Positions in mm, three floats each, of an object's vertices in their order. The buffer needs the
/// usage VK_BUFFER_USAGE_STORAGE_BUFFER_BIT and has to live until every frame that reads it has
/// been collected. Writes to it have to be submitted to the same queue before the frame, and made
/// visible to storage reads of compute shaders. A later write has to wait for these reads: behind a
/// barrier, or until the frame has been collected. A vertex whose position is not finite, or not
/// within 1e9 mm of the middle of the scene, keeps the position that it would have without the
/// buffer.
struct DevicePositions {
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceSize offsetBytes = 0;    ///< multiple of 4
  std::uint32_t strideBytes = 12;  ///< from one position to the next, multiple of 4, at least 12
  bool live = true;  ///< may change at any time; false: changes only before another call of
                     ///< Renderer::replacePositions, so that FrameOrder::reuseLight still works
};

/// Radiance times coverage in RGB, coverage in alpha, linear, top row first. Shaders on the
/// renderer's queue may sample it. The view's next frame waits for shaders that read it, and
/// overwrites it. The image lives until the view gets another size or is destroyed, whatever the
/// scene; both wait for work that uses it and was submitted before.
struct DeviceImage {
  VkImage image = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  VkExtent2D extent{};
};

/// Exitance of an object's vertices in their order, four floats each: R, G, B and the number of
/// evaluations. For opaque bodies it is the irradiance. Any shader, copy or vertex input of later
/// work on the renderer's queue may read it without a barrier; the view's next frame waits for such
/// reads. It lives until another scene or size is set or the view is destroyed. Each of these waits
/// for work that uses it and was submitted before.
struct DeviceBuffer {
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceSize offsetBytes = 0;
  VkDeviceSize bytes = 0;  ///< 16 per vertex
};

/// An image of the caller's that the frame draws into, as large as the view. It has the layout
/// `layout` before and afterwards: VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL, the one for colour or depth,
/// or VK_IMAGE_LAYOUT_GENERAL. The frame waits for earlier commands on the queue that drew into it
/// as an attachment. Other earlier uses need a barrier to the stages colour attachment output and
/// early and late fragment tests; later uses need one from these stages.
struct DeviceTarget {
  VkImage image = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkImageLayout layout = VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL;
  VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;  ///< the same for colour and depth
};

/// Lays the picture over what the caller has drawn with the same CameraMatrices. Edges of bodies
/// are blended with that, so draw opaque things first. A pixel has the depth of the nearest surface
/// that it sees, by viewToClip, reversed or not; lights and sky are behind everything. If targets
/// have several samples, each is tested against its own depth, and all that pass get the pixel's
/// colour, coverage and depth.
struct Composition {
  DeviceTarget color;
  DeviceTarget depth;       ///< tested and written; without an image the picture covers everything
  float radianceScale = 1;  ///< the colour is the radiance times this, linear
};

/// Where the exitance of an object's vertices is copied to, in the layout of DeviceBuffer. The
/// buffer needs the usage VK_BUFFER_USAGE_TRANSFER_DST_BIT. Earlier reads of it have to be over, by
/// a semaphore or a barrier to the transfer stage; later reads need a barrier from it.
struct DeviceExitance {
  std::size_t object = 0;
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceSize offsetBytes = 0;  ///< multiple of 4
};

/// What a frame leaves in the caller's memory. Only read during the call. Exitance needs
/// Site::Vertex as RenderOptions::site.
struct DeviceOutputs {
  const Composition* over = nullptr;
  std::span<const DeviceExitance> exitances;
};

/// A frame that the library submits, with at most 16 waits and 16 signals, each for all stages.
struct FrameSubmission {
  std::span<const TimelinePoint> waits;
  std::span<const TimelinePoint> signals;
  DeviceOutputs outputs;
};

/// A frame that the caller submits itself: once, to the renderer's queue, and before it makes
/// another frame or a step of a soft body with this renderer. Other work may be submitted in
/// between.
struct FrameRecording {
  /// A primary command buffer that has been begun, outside of rendering and of active queries. What
  /// was bound in it is no longer bound afterwards.
  VkCommandBuffer commands = VK_NULL_HANDLE;
  /// Reached when the submission has finished. The library waits for it before it uses memory of
  /// the frame again, and gives up after a minute. The semaphore has to live until the renderer is
  /// destroyed, or View::collect has returned this frame or a later one.
  TimelinePoint finished;
  DeviceOutputs outputs;
};

}  // namespace opaline
