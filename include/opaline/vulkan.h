#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
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

/// Exitance of an object's vertices in their order, R G B and the number of evaluations, four
/// floats each. Of opaque bodies it is the irradiance. Any shader, copy or vertex input of later
/// work on the renderer's queue may read it without a barrier; the view's next frame waits for
/// that. It lives until another scene or size is set, or the view goes away, which waits for work
/// that uses it and was submitted before.
struct DeviceBuffer {
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceSize offsetBytes = 0;
  VkDeviceSize bytes = 0;  ///< 16 a vertex
};

/// An image of the caller's that is drawn into, as large as the view.
/// It is in the layout `layout` before and afterwards: VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL, the one
/// for colour or depth, or VK_IMAGE_LAYOUT_GENERAL. What was drawn into it as an attachment, by
/// earlier commands on the queue, is waited for. Other uses before need a barrier to these stages,
/// and uses afterwards one from them: colour attachment output, early and late fragment tests.
struct DeviceTarget {
  VkImage image = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkImageLayout layout = VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL;
  VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;  ///< the same of colour and depth
};

/// Lays the picture over what the caller has drawn with the same CameraMatrices. Edges of bodies
/// are blended with it, so draw what is opaque first. A pixel has the depth of the nearest surface
/// that it sees, in the sense of viewToClip, reversed or not; lights and sky are behind everything.
/// Where targets have several samples, each is tested against its own depth, and all that pass get
/// the pixel's colour, coverage and depth.
struct Composition {
  DeviceTarget color;
  DeviceTarget depth;       ///< tested and written; without an image the picture lies on top
  float radianceScale = 1;  ///< the colour is the radiance times this, linear
};

/// Where the exitance of an object's vertices is copied to, as DeviceBuffer has it. The buffer has
/// the usage VK_BUFFER_USAGE_TRANSFER_DST_BIT. Earlier reads of it are over, by a semaphore or a
/// barrier to transfer; later ones need a barrier from it.
struct DeviceExitance {
  std::size_t object = 0;
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceSize offsetBytes = 0;  ///< multiple of 4
};

/// What a frame leaves in the caller's memory. Only read during the call. Exitance needs
/// RenderOptions::site Site::Vertex.
struct DeviceOutputs {
  const Composition* over = nullptr;
  std::span<const DeviceExitance> exitances;
};

/// A frame that the library submits. At most 16 points each; waits and signals are for all stages.
struct FrameSubmission {
  std::span<const TimelinePoint> waits;
  std::span<const TimelinePoint> signals;
  DeviceOutputs outputs;
};

/// A frame that the caller submits, once, to the renderer's queue, before it makes another frame or
/// a step of a soft body with this renderer; others may submit in between.
struct FrameRecording {
  /// Primary, begun, outside of rendering and of other queries of its pools; what was bound in it
  /// is not bound afterwards.
  VkCommandBuffer commands = VK_NULL_HANDLE;
  /// Reached when the submission has finished. The library waits for it before it uses memory of
  /// the frame again, and gives up after a minute. The semaphore lives until the renderer goes, or
  /// View::collect has returned this frame or a later one.
  TimelinePoint finished;
  DeviceOutputs outputs;
};

}  // namespace opaline
