#pragma once

/// The caller's Vulkan device in C; part of opaline/opaline_c.h.

#include "opaline/c/rendering.h"
#include "opaline/c/status.h"

OPALINE_C_BEGIN

// Declared only if <vulkan/vulkan.h> was included before. opaline/vulkan.h explains the parts and
// has the rules for layouts, stages, lifetimes and threads.
#ifdef VULKAN_CORE_H_

/// What the library needs of a device; see VulkanNeeds. All of it lives as long as the process.
typedef struct OpalineVulkanNeeds {
  size_t size;  ///< sizeof(OpalineVulkanNeeds)
  uint32_t apiVersion;
  const char* const* requiredExtensions;
  size_t requiredExtensionCount;
  const char* const* optionalExtensions;
  size_t optionalExtensionCount;
  const VkPhysicalDeviceFeatures2* requiredFeatures;
  const VkPhysicalDeviceFeatures2* optionalFeatures;
} OpalineVulkanNeeds;

/// Fills a struct whose size has been set.
OPALINE_API OpalineStatus opalineVulkanNeeds(OpalineVulkanNeeds* needs);

/// Why the library cannot use the device, truncated if it has no room; empty if it can.
OPALINE_API OpalineStatus opalineWhatIsMissing(VkInstance instance, VkPhysicalDevice physicalDevice,
                                               char* sentence, size_t sentenceBytes);

/// A device for OpalineRendererOptions; see GivenVulkan.
typedef struct OpalineGivenVulkan {
  size_t size;  ///< sizeof(OpalineGivenVulkan)
  VkInstance instance;
  VkPhysicalDevice physicalDevice;
  VkDevice device;
  uint32_t queueFamily;
  VkQueue queue;
  PFN_vkGetInstanceProcAddr getInstanceProcAddr;  ///< NULL: the loader that the library links
  const char* const* enabledExtensions;
  size_t enabledExtensionCount;
  const VkPhysicalDeviceFeatures2* enabledFeatures;
  void (*lockQueue)(void* context);    ///< NULL if nobody else uses the queue
  void (*unlockQueue)(void* context);  ///< the same
  void* lockContext;                   ///< for both
} OpalineGivenVulkan;

/// See DevicePositions.
typedef struct OpalineDevicePositions {
  size_t size;  ///< sizeof(OpalineDevicePositions)
  VkBuffer buffer;
  VkDeviceSize offsetBytes;
  uint32_t strideBytes;  ///< 0: 12
} OpalineDevicePositions;

/// Like opalineSetPositions(), from a buffer that every frame reads again.
OPALINE_API OpalineStatus opalineSetDevicePositions(OpalineRenderer* renderer, size_t object,
                                                    const OpalineDevicePositions* positions);

/// The same for a buffer that changes only before another such call, so that frames can still reuse
/// light; see DevicePositions::live.
OPALINE_API OpalineStatus opalineSetStillDevicePositions(OpalineRenderer* renderer, size_t object,
                                                         const OpalineDevicePositions* positions);

/// The Vulkan objects of a renderer, for filling buffers of its device; see VulkanDevice.
typedef struct OpalineVulkanDevice {
  size_t size;  ///< sizeof(OpalineVulkanDevice)
  VkInstance instance;
  VkPhysicalDevice physicalDevice;
  VkDevice device;
  uint32_t queueFamily;
  VkQueue queue;
} OpalineVulkanDevice;

/// Works for a device that the renderer opened and for one that was given.
OPALINE_API OpalineStatus opalineVulkanDevice(const OpalineRenderer* renderer,
                                              OpalineVulkanDevice* device);

/// A value of a timeline semaphore.
typedef struct OpalineTimelinePoint {
  size_t size;  ///< sizeof(OpalineTimelinePoint)
  VkSemaphore semaphore;
  uint64_t value;
} OpalineTimelinePoint;

/// See DeviceTarget.
typedef struct OpalineDeviceTarget {
  size_t size;  ///< sizeof(OpalineDeviceTarget)
  VkImage image;
  VkImageView view;
  VkFormat format;
  VkImageLayout layout;
  uint32_t samples;  ///< per pixel; 0: one
} OpalineDeviceTarget;

/// See Composition.
typedef struct OpalineComposition {
  size_t size;  ///< sizeof(OpalineComposition)
  const OpalineDeviceTarget* color;
  const OpalineDeviceTarget* depth;  ///< may be NULL
  float radianceScale;
} OpalineComposition;

/// See DeviceExitance.
typedef struct OpalineDeviceExitance {
  size_t size;  ///< sizeof(OpalineDeviceExitance)
  size_t object;
  VkBuffer buffer;
  VkDeviceSize offsetBytes;
} OpalineDeviceExitance;

/// A frame on the caller's device; see FrameSubmission, FrameRecording and FrameOrder.
typedef struct OpalineDeviceFrame {
  size_t size;                        ///< sizeof(OpalineDeviceFrame)
  const OpalineTimelinePoint* waits;  ///< none for a recorded frame
  size_t waitCount;
  const OpalineTimelinePoint* signals;  ///< for a recorded frame exactly one, which its submission
                                        ///< signals
  size_t signalCount;
  VkCommandBuffer commands;        ///< of a recorded frame
  const OpalineComposition* over;  ///< may be NULL
  const OpalineDeviceExitance* exitances;
  size_t exitanceCount;
  int32_t onDevice;        ///< 1: leave the radiance for opalineViewPicture()
  int32_t exitance;        ///< 1: leave the exitance of vertices, for opalineViewExitance()
  const OpalineAov* aovs;  ///< for opalineCollect()
  size_t aovCount;
  const OpalineAov* aovsOnDevice;  ///< for opalineViewVariable()
  size_t aovOnDeviceCount;
  int32_t reuseLight;  ///< as in OpalineFrameOrder
  int32_t impatient;   ///< the same
} OpalineDeviceFrame;

/// opalinePrepareFrame() makes all that a frame needs, so that opalineRecordFrame() submits
/// nothing.
OPALINE_API OpalineStatus opalinePrepareFrame(OpalineView* view, const OpalineDeviceFrame* frame);
OPALINE_API OpalineStatus opalineSubmitFrame(OpalineView* view, const OpalineDeviceFrame* frame);
OPALINE_API OpalineStatus opalineRecordFrame(OpalineView* view, const OpalineDeviceFrame* frame);

/// See DeviceImage.
typedef struct OpalineDeviceImage {
  size_t size;  ///< sizeof(OpalineDeviceImage)
  VkImage image;
  VkImageView view;
  VkFormat format;
  VkImageLayout layout;
  uint32_t width;
  uint32_t height;
} OpalineDeviceImage;

/// The picture that the last frame left on the device, if it was ordered to.
OPALINE_API OpalineStatus opalineViewPicture(const OpalineView* view, OpalineDeviceImage* picture);

/// One of the last frame's `aovsOnDevice`; see View::picture.
OPALINE_API OpalineStatus opalineViewVariable(const OpalineView* view, OpalineAov aov,
                                              OpalineDeviceImage* variable);

/// See DeviceBuffer.
typedef struct OpalineDeviceBuffer {
  size_t size;  ///< sizeof(OpalineDeviceBuffer)
  VkBuffer buffer;
  VkDeviceSize offsetBytes;
  VkDeviceSize bytes;
} OpalineDeviceBuffer;

/// The exitance of an object's vertices that the last frame left on the device, if it was ordered
/// to.
OPALINE_API OpalineStatus opalineViewExitance(const OpalineView* view, size_t object,
                                              OpalineDeviceBuffer* exitance);

#endif  // VULKAN_CORE_H_

OPALINE_C_END
