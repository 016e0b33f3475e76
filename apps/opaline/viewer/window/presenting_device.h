#pragma once

#include <vulkan/vulkan.h>

#include "opaline/vulkan.h"

namespace opaline::app::viewer {

/// The device that draws the window. A graphics card draws it between two pictures; a software
/// device, whose only queue is busy with one picture for seconds, has a second logical device
/// beside it, so that controls and the last picture are drawn meanwhile.
class PresentingDevice {
 public:
  /// Beside the device of a renderer, which outlives it.
  explicit PresentingDevice(const VulkanDevice& renderers);
  ~PresentingDevice();
  PresentingDevice(const PresentingDevice&) = delete;
  PresentingDevice& operator=(const PresentingDevice&) = delete;

  const VulkanDevice& device() const { return device_; }

 private:
  void makeOwn();

  VulkanDevice device_;
  bool own_ = false;
};

}  // namespace opaline::app::viewer
