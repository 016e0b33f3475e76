#include "viewer/window/vulkan_check.h"

#include <fmt/format.h>

#include "opaline/error.h"

namespace opaline::app::viewer {

void check(VkResult result, const char* attempt) {
  if (result >= 0) return;
  if (result == VK_ERROR_DEVICE_LOST) {
    throw Error(fmt::format("the window could not {}: the device was lost", attempt));
  }
  throw Error(
      fmt::format("the window could not {}: Vulkan says {}", attempt, static_cast<int>(result)));
}

}  // namespace opaline::app::viewer
