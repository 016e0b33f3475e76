#include "gpu/acceleration_structure.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "gpu/command_list.h"
#include "gpu/device.h"
#include "gpu/vulkan_result.h"

namespace opaline::gpu {

namespace {

constexpr std::size_t cornerBytes = 4 * sizeof(float);
constexpr std::size_t triangleBytes = 3 * cornerBytes;
constexpr std::size_t storageAlignment = 256;  // alignment of structures by the specification
constexpr VkBufferUsageFlags addressed = VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;

std::size_t alignedUp(std::size_t bytes, std::size_t alignment) {
  return (bytes + alignment - 1) / alignment * alignment;
}

VkAccelerationStructureGeometryKHR trianglesAt(VkDeviceAddress corners, std::uint32_t count) {
  VkAccelerationStructureGeometryKHR geometry{};
  geometry.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR;
  geometry.geometryType = VK_GEOMETRY_TYPE_TRIANGLES_KHR;
  geometry.flags = VK_GEOMETRY_OPAQUE_BIT_KHR;
  VkAccelerationStructureGeometryTrianglesDataKHR& triangles = geometry.geometry.triangles;
  triangles.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_TRIANGLES_DATA_KHR;
  triangles.vertexFormat = VK_FORMAT_R32G32B32_SFLOAT;
  triangles.vertexData.deviceAddress = corners;
  triangles.vertexStride = cornerBytes;
  triangles.maxVertex = std::max(3 * count, 1U) - 1;
  triangles.indexType = VK_INDEX_TYPE_NONE_KHR;
  return geometry;
}

VkAccelerationStructureGeometryKHR instancesAt(VkDeviceAddress instances) {
  VkAccelerationStructureGeometryKHR geometry{};
  geometry.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR;
  geometry.geometryType = VK_GEOMETRY_TYPE_INSTANCES_KHR;
  geometry.flags = VK_GEOMETRY_OPAQUE_BIT_KHR;
  geometry.geometry.instances.sType =
      VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_INSTANCES_DATA_KHR;
  geometry.geometry.instances.data.deviceAddress = instances;
  return geometry;
}

// Bits of the mask, which holds a body's class: queries for a single body meet the bodies of its
// class.
constexpr std::uint32_t maskBits = 8;

VkAccelerationStructureInstanceKHR instanceOf(std::uint32_t name, VkDeviceAddress triangles) {
  VkAccelerationStructureInstanceKHR instance{};
  for (int axis = 0; axis < 3; ++axis) instance.transform.matrix[axis][axis] = 1.0F;
  instance.instanceCustomIndex = name & 0xffffffU;
  instance.mask = 1U << name % maskBits;
  instance.accelerationStructureReference = triangles;
  return instance;
}

}  // namespace

AccelerationStructure::AccelerationStructure(Device& device, const std::string& name,
                                             Buffer& corners,
                                             std::span<const std::uint32_t> firstTriangle,
                                             std::span<const std::uint32_t> nameOfBody)
    : AccelerationStructure() {
  assert(device.hasRayQueries() && firstTriangle.size() > 1);
  assert(firstTriangle.back() * triangleBytes <= corners.bytes());
  device_ = &device;
  instances_ = Buffer(
      device,
      {.name = name + ": bodies",
       .bytes = (firstTriangle.size() - 1) * sizeof(VkAccelerationStructureInstanceKHR),
       .usage = VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR | addressed,
       .memory = Memory::Upload});
  describe(corners.address(), firstTriangle);
  makeRoom(name);
  placeBodies(nameOfBody);
  CommandList commands(device, name, 1);
  commands.begin();
  commands.build(*this, corners, false);
  commands.submit();
}

void AccelerationStructure::describe(VkDeviceAddress corners,
                                     std::span<const std::uint32_t> firstTriangle) {
  for (std::size_t body = 0; body + 1 < firstTriangle.size(); ++body) {
    const std::uint32_t count = firstTriangle[body + 1] - firstTriangle[body];
    geometries_.push_back(trianglesAt(corners + firstTriangle[body] * triangleBytes, count));
    // Queries tell bodies of one class apart triangle by triangle.
    if (firstTriangle.size() - 1 > maskBits) geometries_.back().flags = 0;
    ranges_.push_back({count, 0, 0, 0});
  }
  const auto bodies = static_cast<std::uint32_t>(ranges_.size());
  geometries_.push_back(instancesAt(instances_.address()));
  ranges_.push_back({bodies, 0, 0, 0});
  builds_.reserve(geometries_.size());
  for (std::size_t i = 0; i < geometries_.size(); ++i) {
    VkAccelerationStructureBuildGeometryInfoKHR build{};
    build.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_GEOMETRY_INFO_KHR;
    build.type = i < bodies ? VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR
                            : VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR;
    build.flags = VK_BUILD_ACCELERATION_STRUCTURE_PREFER_FAST_TRACE_BIT_KHR;
    if (i < bodies) build.flags |= VK_BUILD_ACCELERATION_STRUCTURE_ALLOW_UPDATE_BIT_KHR;
    build.geometryCount = 1;
    build.pGeometries = &geometries_[i];
    builds_.push_back(build);
    rangeOfBuild_.push_back(&ranges_[i]);
  }
}

void AccelerationStructure::makeRoom(const std::string& name) {
  const VkDeviceSize scratchAlignment = device_->rays().scratchAlignment;
  std::vector<VkAccelerationStructureCreateInfoKHR> infos;
  VkDeviceSize storageBytes = 0;
  VkDeviceSize scratchBytes = 0;
  for (std::size_t i = 0; i < builds_.size(); ++i) {
    VkAccelerationStructureBuildSizesInfoKHR sizes{};
    sizes.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_SIZES_INFO_KHR;
    device_->rays().buildSizes(device_->handle(), VK_ACCELERATION_STRUCTURE_BUILD_TYPE_DEVICE_KHR,
                               &builds_[i], &ranges_[i].primitiveCount, &sizes);
    VkAccelerationStructureCreateInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_CREATE_INFO_KHR;
    info.offset = storageBytes;
    info.size = sizes.accelerationStructureSize;
    info.type = builds_[i].type;
    infos.push_back(info);
    storageBytes += alignedUp(info.size, storageAlignment);
    builds_[i].scratchData.deviceAddress = scratchBytes;  // an offset; the buffer's address is
                                                          // added below
    scratchBytes +=
        alignedUp(std::max(sizes.buildScratchSize, sizes.updateScratchSize), scratchAlignment);
  }
  storage_ = Buffer(*device_,
                    {.name = name,
                     .bytes = storageBytes,
                     .usage = VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_STORAGE_BIT_KHR | addressed});
  scratch_ = Buffer(*device_, {.name = name + ": scratch",
                               .bytes = scratchBytes + scratchAlignment,
                               .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | addressed});
  const VkDeviceAddress scratch = alignedUp(scratch_.address(), scratchAlignment);
  for (std::size_t i = 0; i < builds_.size(); ++i) {
    infos[i].buffer = storage_.handle();
    builds_[i].scratchData.deviceAddress += scratch;
    check(device_->rays().create(device_->handle(), &infos[i], nullptr,
                                 &builds_[i].dstAccelerationStructure),
          fmt::format("create the acceleration structure \"{}\"", name));
    device_->setName(VK_OBJECT_TYPE_ACCELERATION_STRUCTURE_KHR,
                     reinterpret_cast<std::uint64_t>(builds_[i].dstAccelerationStructure), name);
  }
}

void AccelerationStructure::placeBodies(std::span<const std::uint32_t> nameOfBody) {
  const auto instances = instances_.mappedAs<VkAccelerationStructureInstanceKHR>();
  for (std::uint32_t body = 0; body < instances.size(); ++body) {
    VkAccelerationStructureDeviceAddressInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_DEVICE_ADDRESS_INFO_KHR;
    info.accelerationStructure = builds_[body].dstAccelerationStructure;
    const std::uint32_t name = nameOfBody.empty() ? body : nameOfBody[body];
    instances[body] = instanceOf(name, device_->rays().address(device_->handle(), &info));
  }
}

void AccelerationStructure::recordTriangles(VkCommandBuffer commands, bool refit) {
  const std::size_t bodies = builds_.size() - 1;
  for (std::size_t i = 0; i < bodies; ++i) {
    builds_[i].mode = refit ? VK_BUILD_ACCELERATION_STRUCTURE_MODE_UPDATE_KHR
                            : VK_BUILD_ACCELERATION_STRUCTURE_MODE_BUILD_KHR;
    builds_[i].srcAccelerationStructure =
        refit ? builds_[i].dstAccelerationStructure : VK_NULL_HANDLE;
  }
  device_->rays().build(commands, static_cast<std::uint32_t>(bodies), builds_.data(),
                        rangeOfBuild_.data());
}

void AccelerationStructure::recordBodies(VkCommandBuffer commands) {
  device_->rays().build(commands, 1, &builds_.back(), &rangeOfBuild_.back());
}

AccelerationStructure::~AccelerationStructure() {
  for (const VkAccelerationStructureBuildGeometryInfoKHR& build : builds_)
    device_->retire(VK_OBJECT_TYPE_ACCELERATION_STRUCTURE_KHR, build.dstAccelerationStructure);
}

AccelerationStructure::AccelerationStructure(AccelerationStructure&& other) noexcept {
  swap(other);
}

AccelerationStructure& AccelerationStructure::operator=(AccelerationStructure&& other) noexcept {
  AccelerationStructure taken(std::move(other));
  swap(taken);
  return *this;
}

void AccelerationStructure::swap(AccelerationStructure& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(geometries_, other.geometries_);
  std::swap(ranges_, other.ranges_);
  std::swap(builds_, other.builds_);
  std::swap(rangeOfBuild_, other.rangeOfBuild_);
  std::swap(instances_, other.instances_);
  std::swap(storage_, other.storage_);
  std::swap(scratch_, other.scratch_);
}

}  // namespace opaline::gpu
