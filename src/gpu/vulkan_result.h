#pragma once

#include <vulkan/vulkan.h>

#include <string>

namespace opaline::gpu {

/// The name of a result, as in VK_ERROR_DEVICE_LOST.
std::string toString(VkResult result);

/// Throws Error when `result` is a failure; `attempt` completes "Vulkan could not …".
void check(VkResult result, const char* attempt);
void check(VkResult result, const std::string& attempt);

}  // namespace opaline::gpu
