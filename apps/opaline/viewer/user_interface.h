#pragma once

#include <vulkan/vulkan.h>

#include "opaline/vulkan.h"
#include "viewer/presenter.h"
#include "viewer/window.h"

namespace opaline::app::viewer {

/// Dear ImGui in a window: its fonts, colours, input and drawing.
class UserInterface {
 public:
  UserInterface(const VulkanDevice& device, const Presenter& presenter, const Window& window);
  ~UserInterface();
  UserInterface(const UserInterface&) = delete;
  UserInterface& operator=(const UserInterface&) = delete;

  /// Between these two, ImGui's own functions say what there is to see.
  void begin();
  void end();
  /// Draws it over what the commands have drawn.
  void draw(VkCommandBuffer commands) const;

 private:
  void makeFonts(float scale) const;
  void uploadFonts() const;

  VulkanDevice device_;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
};

}  // namespace opaline::app::viewer
