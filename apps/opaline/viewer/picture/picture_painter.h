#pragma once

#include <vulkan/vulkan.h>

#include "opaline/tone.h"
#include "opaline/vulkan.h"

namespace opaline::app::viewer {

/// An area of the window in pixels, from its top left corner.
struct Area {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  bool empty() const { return width <= 0 || height <= 0; }
  float aspect() const { return static_cast<float>(width) / static_cast<float>(height); }
  bool holds(float px, float py) const {
    return px >= static_cast<float>(x) && py >= static_cast<float>(y) &&
           px < static_cast<float>(x + width) && py < static_cast<float>(y + height);
  }
  /// Whether it holds all that is up to `margin` to each side of the point.
  bool holds(float px, float py, float margin) const {
    return holds(px - margin, py - margin) && holds(px + margin, py + margin);
  }
};

/// The largest area with a picture's proportions within another.
Area fitted(const Area& area, int width, int height);

/// Draws linear pictures into the window, with exposure, tone curve and sRGB as in toneMap.
class PicturePainter {
 public:
  PicturePainter(const VulkanDevice& device, VkRenderPass renderPass);
  ~PicturePainter();
  PicturePainter(const PicturePainter&) = delete;
  PicturePainter& operator=(const PicturePainter&) = delete;

  /// Lets `picture` fill `place` but draws only `visible`; both lie within the window. A tone
  /// without background means black.
  void draw(VkCommandBuffer commands, const DeviceImage& picture, const Area& place,
            const Area& visible, const ToneOptions& tone) const;

 private:
  void makeLayout();
  void makePipeline(VkRenderPass renderPass);

  VulkanDevice device_;
  PFN_vkCmdPushDescriptorSetKHR pushDescriptorSet_ = nullptr;
  VkSampler sampler_ = VK_NULL_HANDLE;
  VkDescriptorSetLayout sets_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
};

}  // namespace opaline::app::viewer
