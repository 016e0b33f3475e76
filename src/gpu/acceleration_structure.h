#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gpu/buffer.h"

namespace opaline::gpu {

class Device;

/// The structure that ray queries of shaders (VK_KHR_ray_query) send rays through. Each body of
/// triangles is an instance whose custom index is the body's name and whose mask is 1 << name % 8.
/// With more than eight bodies, triangles are not opaque. Triangles may move, but their number
/// stays. Movable.
class AccelerationStructure {
 public:
  AccelerationStructure() = default;
  /// Builds the structure of the triangles' present places: for set-up, not for frames. `corners`
  /// holds three vec4 per triangle and was made with cornersUsage. Body i has the triangles from
  /// firstTriangle[i] on; firstTriangle has one more entry than there are bodies. Bodies are named
  /// by their numbers, or as given. Needs Device::hasRayQueries().
  AccelerationStructure(Device& device, const std::string& name, Buffer& corners,
                        std::span<const std::uint32_t> firstTriangle,
                        std::span<const std::uint32_t> nameOfBody = {});
  ~AccelerationStructure();
  AccelerationStructure(AccelerationStructure&& other) noexcept;
  AccelerationStructure& operator=(AccelerationStructure&& other) noexcept;
  AccelerationStructure(const AccelerationStructure&) = delete;
  AccelerationStructure& operator=(const AccelerationStructure&) = delete;

  /// Additional usage of a buffer that holds corners.
  static constexpr VkBufferUsageFlags cornersUsage =
      VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR |
      VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;

  explicit operator bool() const { return device_ != nullptr; }
  VkAccelerationStructureKHR handle() const { return builds_.back().dstAccelerationStructure; }
  Buffer& storage() { return storage_; }

  /// For CommandTape: the builds of triangles, then of the bodies that consist of them.
  void recordTriangles(VkCommandBuffer commands, bool refit);
  void recordBodies(VkCommandBuffer commands);

 private:
  friend class CommandList;

  void describe(VkDeviceAddress corners, std::span<const std::uint32_t> firstTriangle);
  void makeRoom(const std::string& name);
  void placeBodies(std::span<const std::uint32_t> nameOfBody);
  void swap(AccelerationStructure& other) noexcept;

  Device* device_ = nullptr;
  // What the build commands read, made once: for the triangles of each body, then for the bodies.
  std::vector<VkAccelerationStructureGeometryKHR> geometries_;
  std::vector<VkAccelerationStructureBuildGeometryInfoKHR> builds_;
  std::vector<VkAccelerationStructureBuildRangeInfoKHR> ranges_;
  std::vector<const VkAccelerationStructureBuildRangeInfoKHR*> rangeOfBuild_;
  Buffer instances_;
  Buffer storage_;  // of all structures
  Buffer scratch_;
};

}  // namespace opaline::gpu
