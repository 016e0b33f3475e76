#pragma once

#include <imgui.h>
#include <vulkan/vulkan.h>

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "opaline/vulkan.h"
#include "viewer/window/presenter.h"
#include "viewer/window/window.h"

namespace opaline::app::viewer {

/// Dear ImGui in a window: its fonts, colours, input and drawing.
class UserInterface {
 public:
  UserInterface(const VulkanDevice& device, const Presenter& presenter, const Window& window);
  ~UserInterface();
  UserInterface(const UserInterface&) = delete;
  UserInterface& operator=(const UserInterface&) = delete;

  /// Between begin() and end(), ImGui's own functions describe what is shown. Where texts need new
  /// characters (see glyphs.h), fonts that have them are loaded first.
  void begin(const std::vector<Input>& inputs);
  void end();
  /// Draws the interface over what the commands have drawn so far.
  void draw(VkCommandBuffer commands) const;

 private:
  void beginDrawing();
  void makeFonts();
  void uploadFonts() const;
  void take(const Input& input);
  void setMouse() const;

  VulkanDevice device_;
  const Presenter& presenter_;
  const Window& window_;
  std::deque<ImVector<ImWchar>> ranges_;                // of the fonts, which hold pointers to them
  std::optional<ImVec2> pointer_;                       // as of the inputs taken so far
  std::array<bool, ImGuiMouseButton_COUNT> buttons_{};  // pressed, as of those inputs
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
};

}  // namespace opaline::app::viewer
