#pragma once

#include <vulkan/vulkan.h>

#include <functional>

#include "opaline/vulkan.h"

namespace opaline::app::viewer {

// Vulkan objects that several parts of the window need. Each function throws Error, "the window
// could not <attempt>", on failure.

VkCommandPool makeCommandPool(const VulkanDevice& device, VkCommandPoolCreateFlags flags,
                              const char* attempt);
VkCommandBuffer makeCommands(VkDevice device, VkCommandPool pool, const char* attempt);
/// Begins commands for one submission; they are recorded again before the next.
void beginCommands(VkCommandBuffer commands, const char* attempt);

/// A view of all of an image's colours.
VkImageView makeView(VkDevice device, VkImage image, VkFormat format, const char* attempt);

/// Runs the recorded commands on the device, and waits until they are done.
void runOnce(const VulkanDevice& device, const std::function<void(VkCommandBuffer)>& record,
             const char* attempt);

}  // namespace opaline::app::viewer
