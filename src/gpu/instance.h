#pragma once

#include <vulkan/vulkan.h>

#include <atomic>
#include <cstddef>
#include <string>
#include <vector>

#include "opaline/log.h"

namespace opaline::gpu {

/// The connection to the Vulkan loader, with the validation layer if requested.
class Instance {
 public:
  /// `extensions` are added to its own. Throws Error when there is no driver, or when the
  /// validation layer or an extension is missing.
  explicit Instance(bool validation = false, LogCallback log = {},
                    const std::vector<std::string>& extensions = {});
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  VkInstance handle() const { return instance_; }
  std::vector<VkPhysicalDevice> physicalDevices() const;

  /// Warnings and errors of the validation layer so far.
  std::size_t messages() const { return messages_; }
  /// For the messenger: counts one and hands it to the log.
  void report(VkDebugUtilsMessageSeverityFlagBitsEXT severity, const char* message);

 private:
  void create(bool validation, const std::vector<std::string>& wanted);

  LogCallback log_;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  std::atomic<std::size_t> messages_ = 0;
};

/// The message for a machine without a driver or device.
extern const char* const noDeviceMessage;

}  // namespace opaline::gpu
