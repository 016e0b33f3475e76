#pragma once

#include <vulkan/vulkan.h>

#include <functional>

#include "opaline/vulkan.h"

namespace opaline::app::viewer {

// What several parts of the window make of Vulkan. Each throws Error, "the window could not
// <attempt>", where that fails.

VkCommandPool makeCommandPool(const VulkanDevice& device, VkCommandPoolCreateFlags flags,
                              const char* attempt);
VkCommandBuffer makeCommands(VkDevice device, VkCommandPool pool, const char* attempt);
/// They are submitted once and recorded anew before they are submitted again.
void beginCommands(VkCommandBuffer commands, const char* attempt);

/// Of all of an image's colours.
VkImageView makeView(VkDevice device, VkImage image, VkFormat format, const char* attempt);

/// Has the device do what is recorded, and waits until it is done.
void runOnce(const VulkanDevice& device, const std::function<void(VkCommandBuffer)>& record,
             const char* attempt);

}  // namespace opaline::app::viewer
