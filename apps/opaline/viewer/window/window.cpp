#include "viewer/window/window.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

// Included after vulkan.h, so that it declares its functions for Vulkan.
#include <GLFW/glfw3.h>

#include "opaline/error.h"

namespace opaline::app::viewer {

namespace {

std::string lastError() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "no reason was given";
}

Window& windowOf(GLFWwindow* handle) {
  return *static_cast<Window*>(glfwGetWindowUserPointer(handle));
}

}  // namespace

Window::Window(int width, int height, const char* title) {
  if (glfwInit() == GLFW_FALSE) {
    throw Error(fmt::format(
        "view found no display to open a window on ({}); opaline render makes pictures without one",
        lastError()));
  }
  if (glfwVulkanSupported() == GLFW_FALSE) {
    glfwTerminate();
    throw Error("view found no Vulkan driver that draws into windows; install one, or use render");
  }
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  window_ = glfwCreateWindow(width, height, title, nullptr, nullptr);
  if (window_ == nullptr) {
    const std::string reason = lastError();
    glfwTerminate();
    throw Error(
        fmt::format("view could not open a window: {}; opaline render works without one", reason));
  }
  glfwSetWindowSizeLimits(window_, 320, 240, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwSetWindowUserPointer(window_, this);
  glfwSetDropCallback(window_, [](GLFWwindow* handle, int count, const char** paths) {
    Window& window = windowOf(handle);
    for (int i = 0; i < count; ++i) window.dropped_.emplace_back(paths[i]);
  });
  takeInput();
  glfwSetWindowRefreshCallback(window_,
                               [](GLFWwindow* handle) { windowOf(handle).refresh_ = true; });
  glfwSetFramebufferSizeCallback(
      window_, [](GLFWwindow* handle, int, int) { windowOf(handle).refresh_ = true; });
}

void Window::takeInput() {
  using Kind = Input::Kind;
  glfwSetKeyCallback(window_, [](GLFWwindow* handle, int key, int code, int action, int mods) {
    windowOf(handle).take(
        {.kind = Kind::Key, .code = key, .scanCode = code, .action = action, .modifiers = mods});
  });
  glfwSetCharCallback(window_, [](GLFWwindow* handle, unsigned int typed) {
    windowOf(handle).take({.kind = Kind::Text, .typed = typed});
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* handle, int button, int action, int mods) {
    windowOf(handle).take(
        {.kind = Kind::Button, .code = button, .action = action, .modifiers = mods});
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* handle, double x, double y) {
    windowOf(handle).take({.kind = Kind::Wheel, .x = x, .y = y});
  });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* handle, double x, double y) {
    windowOf(handle).inputs_.add({.kind = Kind::Pointer, .x = x, .y = y});
  });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* handle, int entered) {
    if (entered == GLFW_FALSE) windowOf(handle).inputs_.add({.kind = Kind::Left});
  });
}

void Window::take(const Input& input) {
  inputs_.add(input);
  refresh_ = true;
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

std::vector<std::string> Window::instanceExtensions() {
  std::uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  if (names == nullptr) {
    throw Error(
        fmt::format("view cannot draw into windows with this Vulkan driver: {}", lastError()));
  }
  return {names, names + count};
}

std::vector<std::string> Window::deviceExtensions() {
  return {VK_KHR_SWAPCHAIN_EXTENSION_NAME};
}

VkSurfaceKHR Window::makeSurface(VkInstance instance) const {
  VkSurfaceKHR surface = VK_NULL_HANDLE;
  if (glfwCreateWindowSurface(instance, window_, nullptr, &surface) != VK_SUCCESS) {
    throw Error(fmt::format("view could not draw into its window: {}", lastError()));
  }
  return surface;
}

std::array<int, 2> Window::size() const {
  if (glfwGetWindowAttrib(window_, GLFW_ICONIFIED) != GLFW_FALSE) return {};
  const auto unscaled = [this](std::uint32_t pixels) {
    return static_cast<int>(std::lround(static_cast<float>(pixels) / scale()));
  };
  return {unscaled(pixels().width), unscaled(pixels().height)};
}

VkExtent2D Window::pixels() const {
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

float Window::scale() const {
  float x = 1;
  float y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  return x > 0 ? x : 1;
}

bool Window::wantsToClose() const {
  return glfwWindowShouldClose(window_) != GLFW_FALSE;
}

void Window::close() {
  glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

void Window::stay() {
  glfwSetWindowShouldClose(window_, GLFW_FALSE);
}

void Window::hide() {
  glfwHideWindow(window_);
}

void Window::setTitle(const std::string& title) {
  glfwSetWindowTitle(window_, title.c_str());
}

void Window::poll() {
  glfwPollEvents();
}

void Window::wait(double seconds) {
  if (seconds > 0) {
    glfwWaitEventsTimeout(seconds);
  } else {
    glfwWaitEvents();
  }
}

void Window::wake() {
  glfwPostEmptyEvent();
}

std::vector<std::filesystem::path> Window::takeDropped() {
  return std::exchange(dropped_, {});
}

std::vector<Input> Window::takeInputs() {
  return inputs_.takeFrame();
}

bool Window::takeRefresh() {
  return std::exchange(refresh_, false);
}

}  // namespace opaline::app::viewer
