#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>

#include "opaline/image.h"
#include "opaline/vulkan.h"

namespace opaline::app::viewer {

/// A picture that is copied from the host to the device, for PicturePainter to draw. Setting it
/// waits for the device, so it is not meant for every frame.
class HostPicture {
 public:
  explicit HostPicture(const VulkanDevice& device) : device_(device) {}
  ~HostPicture();
  HostPicture(const HostPicture&) = delete;
  HostPicture& operator=(const HostPicture&) = delete;

  void set(const Image& image);
  void clear();
  bool empty() const { return shown_.view == VK_NULL_HANDLE; }
  const DeviceImage& shown() const { return shown_; }

 private:
  void makeImage(VkExtent2D extent);
  VkDeviceMemory allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted) const;
  void upload(const void* texels, std::size_t bytes);

  VulkanDevice device_;
  DeviceImage shown_;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
};

}  // namespace opaline::app::viewer
