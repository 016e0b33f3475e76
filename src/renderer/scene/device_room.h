#pragma once

#include <cstddef>
#include <string>

#include <vulkan/vulkan.h>

namespace opaline {

/// How much of a scene's surface a device has room for: all that one kind of thing needs is read
/// from one buffer.
struct DeviceRoom {
  std::size_t triangles = 0;  ///< in surfels
  std::size_t surfels = 0;
  std::size_t clusters = 0;
};

DeviceRoom roomOf(const VkPhysicalDeviceLimits& limits);

/// Throws Error for more triangles than there is room for. Quick, so that it is said at once.
void requireRoom(std::size_t triangles, const DeviceRoom& room, const std::string& device);

}  // namespace opaline
