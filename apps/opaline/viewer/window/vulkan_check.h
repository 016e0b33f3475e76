#pragma once

#include <vulkan/vulkan.h>

namespace opaline::app::viewer {

/// Throws Error, "the window could not <attempt>", where a call failed.
void check(VkResult result, const char* attempt);

}  // namespace opaline::app::viewer
