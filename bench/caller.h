#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "opaline/renderer.h"
#include "opaline/vulkan.h"

namespace opaline::bench {

/// A caller that records frames into its own command buffers and submits them, on the device of a
/// renderer, which must outlive it. Two frames are under way; the destructor waits for both.
class Caller {
 public:
  explicit Caller(const Renderer& renderer);
  ~Caller();
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;

  /// Waits for the last frame but one and begins a command buffer.
  FrameRecording begin();
  /// Ends and submits it.
  void submit(const FrameRecording& recording);

 private:
  VulkanDevice vulkan_;
  VkSemaphore timeline_ = VK_NULL_HANDLE;
  std::array<VkCommandPool, 2> pools_{};
  std::array<VkCommandBuffer, 2> buffers_{};
  std::uint64_t frames_ = 0;
};

}  // namespace opaline::bench
