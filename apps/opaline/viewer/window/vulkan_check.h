#pragma once

#include <vulkan/vulkan.h>

namespace opaline::app::viewer {

/// Throws Error, "the window could not <attempt>", if `result` is an error.
void check(VkResult result, const char* attempt);

}  // namespace opaline::app::viewer
