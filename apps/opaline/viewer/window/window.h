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
  /// Throws Error where there is no display, or none that Vulkan can draw to.
  Window(int width, int height, const char* title);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// What Vulkan needs to draw into it.
  static std::vector<std::string> instanceExtensions();
  static std::vector<std::string> deviceExtensions();
  /// The caller destroys it, before the window.
  VkSurfaceKHR makeSurface(VkInstance instance) const;

  GLFWwindow* handle() const { return window_; }
  std::array<int, 2> size() const;  ///< as asked for, before scale(); 0 while it is minimised
  VkExtent2D pixels() const;        ///< 0 × 0 while it is minimised
  /// How much larger the desktop wants text and controls than usual.
  float scale() const;
  bool wantsToClose() const;
  void close();
  /// Goes on where it was to be closed.
  void stay();
  void setTitle(const std::string& title);

  /// Takes what happened since the last call without waiting.
  static void poll();
  /// The same, but sleeps until something happens, or for so long where seconds > 0.
  static void wait(double seconds = 0);
  /// Ends a wait(), from any thread.
  static void wake();

  /// The files that were dropped on the window since the last call.
  std::vector<std::filesystem::path> takeDropped();
  /// What was done with keys and mouse next, as much as one frame of the interface can tell apart.
  std::vector<Input> takeInputs();
  /// Whether some of it still waits.
  bool hasInputs() const { return !inputs_.empty(); }
  /// Whether the window is to be drawn again: the desktop asked for it, or changed its size, or a
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
