#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "viewer/window/input_queue.h"

struct GLFWwindow;

namespace opaline::app::viewer {

/// A window on the desktop.
class Window {
 public:
  /// Throws Error where there is no display, or none on which Vulkan can draw.
  Window(int width, int height, const char* title);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// The extensions that Vulkan needs to draw into the window.
  static std::vector<std::string> instanceExtensions();
  static std::vector<std::string> deviceExtensions();
  /// The caller must destroy the surface before the window.
  VkSurfaceKHR makeSurface(VkInstance instance) const;

  GLFWwindow* handle() const { return window_; }
  std::array<int, 2> size() const;  ///< as requested, before scale(); 0 while minimised
  VkExtent2D pixels() const;        ///< 0 × 0 while minimised
  /// How much larger than usual the desktop wants text and controls.
  float scale() const;
  bool wantsToClose() const;
  void close();
  /// Cancels the wish to close.
  void stay();
  void hide();
  void setTitle(const std::string& title);

  /// Takes the events since the last call without waiting.
  static void poll();
  /// The same, but sleeps until something happens, or at most so long where seconds > 0.
  static void wait(double seconds = 0);
  /// Ends a wait(), from any thread.
  static void wake();

  /// The files dropped on the window since the last call.
  std::vector<std::filesystem::path> takeDropped();
  /// The next inputs of keys and mouse, as many as one frame of the interface can tell apart.
  std::vector<Input> takeInputs();
  /// Whether inputs are still waiting.
  bool hasInputs() const { return !inputs_.empty(); }
  /// Whether the window must be drawn again: the desktop asked for it or changed its size, or a
  /// key, a button or the wheel was used.
  bool takeRefresh();

 private:
  void takeInput();
  void take(const Input& input);

  GLFWwindow* window_ = nullptr;
  std::vector<std::filesystem::path> dropped_;
  InputQueue inputs_;
  bool refresh_ = true;
};

}  // namespace opaline::app::viewer
