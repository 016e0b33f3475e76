#pragma once

#include <vulkan/vulkan.h>

#include "opaline/vulkan.h"

namespace opaline::app::viewer {

/// The device that draws the window. A graphics card draws it between two pictures. The only queue
/// of a software device can be busy with one picture for seconds, so it gets a second logical
/// device that draws controls and the last picture meanwhile.
class PresentingDevice {
 public:
  /// Made from the device of a renderer, which must outlive it.
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
