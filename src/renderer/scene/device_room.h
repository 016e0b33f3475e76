#pragma once

#include <cstddef>
#include <string>

#include <vulkan/vulkan.h>

namespace opaline {

/// How much of a scene's surface a device has room for. The limit is the size of one buffer, as all
/// things of a kind are in one.
struct DeviceRoom {
  std::size_t triangles = 0;  ///< divided into surfels
  std::size_t surfels = 0;
  std::size_t clusters = 0;
};

DeviceRoom roomOf(const VkPhysicalDeviceLimits& limits);

/// Throws Error for more triangles than there is room for. It is quick, so that the user learns it
/// at once.
void requireRoom(std::size_t triangles, const DeviceRoom& room, const std::string& device);

}  // namespace opaline
