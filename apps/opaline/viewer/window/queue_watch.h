#pragma once

#include <vulkan/vulkan.h>

#include "opaline/vulkan.h"

namespace opaline::app::viewer {

/// Tells without waiting whether a device has done what was submitted to its queue.
class QueueWatch {
 public:
  explicit QueueWatch(const VulkanDevice& device);
  ~QueueWatch();
  QueueWatch(const QueueWatch&) = delete;
  QueueWatch& operator=(const QueueWatch&) = delete;

  /// Watches everything submitted so far. Waits for what was watched before.
  void begin();
  bool isDone() const;

 private:
  VulkanDevice device_;
  VkFence done_ = VK_NULL_HANDLE;
};

}  // namespace opaline::app::viewer
