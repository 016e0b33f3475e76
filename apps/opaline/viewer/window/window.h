#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

struct GLFWwindow;

namespace opaline::app::viewer {

/// A key that went down, or repeats because it stays down. Kept by the window because a key that
/// is up again before the next frame would be lost otherwise.
struct KeyPress {
  int key = 0;         ///< GLFW's name of it, a letter's where the keyboard's own layout has it;
                       ///< 0 where only `typed` is known
  char32_t typed = 0;  ///< what it typed; 0 where only `key` is known
  bool control = false;
  bool shift = false;
  bool alt = false;
  bool repeated = false;
};

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
  /// The keys that were pressed since the last call.
  std::vector<KeyPress> takeKeys();
  /// Whether a key or a button of the mouse went down since the last call.
  bool takePress();
  /// Whether the window is to be drawn again: the desktop asked for it, or changed its size, or a
  /// key, a button or the wheel was used.
  bool takeRefresh();
  /// How many keys and buttons went down or up and how often the wheel turned, since it opened.
  std::size_t inputs() const { return inputs_; }

 private:
  void takeInput();
  void takeUse();

  GLFWwindow* window_ = nullptr;
  std::vector<std::filesystem::path> dropped_;
  std::vector<KeyPress> keys_;
  bool pressed_ = false;
  bool refresh_ = true;
  std::size_t inputs_ = 0;
};

}  // namespace opaline::app::viewer
