#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "opaline/vulkan.h"
#include "viewer/window/window.h"

namespace opaline::app::viewer {

/// Shows what is drawn in a render pass in a window, in step with the display. At most
/// framesInFlight frames are under way: begin() waits for the last but one.
class Presenter {
 public:
  static constexpr std::size_t framesInFlight = 2;

  Presenter(const VulkanDevice& device, const Window& window);
  ~Presenter();
  Presenter(const Presenter&) = delete;
  Presenter& operator=(const Presenter&) = delete;

  VkRenderPass renderPass() const { return renderPass_; }
  VkExtent2D extent() const { return extent_; }
  std::uint32_t imageCount() const { return static_cast<std::uint32_t>(images_.size()); }

  /// Commands inside the render pass, on a cleared surface. None while the window has no area.
  std::optional<VkCommandBuffer> begin();
  /// Submits and presents them.
  void end();

  void waitIdle() const;

 private:
  struct Image {
    VkImageView view = VK_NULL_HANDLE;
    VkFramebuffer framebuffer = VK_NULL_HANDLE;
    VkSemaphore rendered = VK_NULL_HANDLE;
  };
  struct Slot {
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkFence done = VK_NULL_HANDLE;
    VkSemaphore acquired = VK_NULL_HANDLE;
  };

  void requirePresenting() const;
  void chooseFormat();
  void makeRenderPass();
  void makeSlots();
  bool makeSwapchain();
  void makeImages();
  void dropImages();
  void dropSwapchain();
  void remakeSurface();
  void destroy();
  bool acquire();

  VulkanDevice device_;
  const Window& window_;
  VkSurfaceKHR surface_ = VK_NULL_HANDLE;
  VkSurfaceFormatKHR format_{};
  VkRenderPass renderPass_ = VK_NULL_HANDLE;
  VkCommandPool pool_ = VK_NULL_HANDLE;
  std::array<Slot, framesInFlight> slots_;
  std::size_t slot_ = 0;
  VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
  VkExtent2D extent_{};
  std::vector<Image> images_;
  std::uint32_t image_ = 0;  // of the current frame
  bool outdated_ = true;
};

}  // namespace opaline::app::viewer
