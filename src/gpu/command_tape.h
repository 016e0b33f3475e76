#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "gpu/access.h"

namespace opaline::gpu {

class AccelerationStructure;
class Device;

/// The commands of a tape, each with all that Vulkan is told and nothing else.
namespace tape {

struct Barriers {
  AccessBarrier memory;
  std::uint32_t images = 0;
  bool operator==(const Barriers&) const = default;
};
struct ImageBarrier {
  VkImage image = VK_NULL_HANDLE;
  VkImageAspectFlags aspect = 0;
  AccessBarrier access;
  bool operator==(const ImageBarrier&) const = default;
};

struct BindPipeline {
  VkPipelineBindPoint point = VK_PIPELINE_BIND_POINT_COMPUTE;
  VkPipeline pipeline = VK_NULL_HANDLE;
  bool operator==(const BindPipeline&) const = default;
};
struct BindResources {
  VkPipelineBindPoint point = VK_PIPELINE_BIND_POINT_COMPUTE;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  std::uint32_t resources = 0;
  bool operator==(const BindResources&) const = default;
};
struct Resource {
  std::uint32_t slot = 0;
  VkDescriptorType type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  // Which of these are set depends on the type.
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceSize offset = 0;
  VkDeviceSize range = 0;
  VkBufferView texels = VK_NULL_HANDLE;
  VkSampler sampler = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
  VkImageLayout imageLayout = VK_IMAGE_LAYOUT_UNDEFINED;
  VkAccelerationStructureKHR structure = VK_NULL_HANDLE;
  bool operator==(const Resource&) const = default;
};
struct PushConstants {
  VkPipelineLayout layout = VK_NULL_HANDLE;
  VkShaderStageFlags stages = 0;
  std::uint32_t bytes = 0;
  bool operator==(const PushConstants&) const = default;
};

struct Dispatch {
  std::uint32_t firstRow = 0;
  std::uint32_t groupsX = 1;
  std::uint32_t groupsY = 1;
  std::uint32_t groupsZ = 1;
  bool operator==(const Dispatch&) const = default;
};
struct DispatchIndirect {
  VkBuffer groups = VK_NULL_HANDLE;
  VkDeviceSize offset = 0;
  bool operator==(const DispatchIndirect&) const = default;
};

struct BeginRendering {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t colors = 0;
  bool depth = false;  // the last of its targets
  bool operator==(const BeginRendering&) const = default;
};
struct Target {
  VkImageView view = VK_NULL_HANDLE;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  bool clear = true;
  bool write = true;
  std::array<std::uint32_t, 4> clearBits{};  // bits of floats
  bool operator==(const Target&) const = default;
};
struct EndRendering {
  bool operator==(const EndRendering&) const = default;
};
struct Draw {
  std::uint32_t vertices = 0;
  std::uint32_t firstVertex = 0;
  bool operator==(const Draw&) const = default;
};
struct DrawIndexed {
  VkBuffer indices = VK_NULL_HANDLE;
  std::uint32_t count = 0;
  std::uint32_t firstIndex;
  bool operator==(const DrawIndexed&) const = default;
};

struct CopyBuffer {
  VkBuffer from = VK_NULL_HANDLE;
  VkBuffer to = VK_NULL_HANDLE;
  VkDeviceSize fromOffset = 0;
  VkDeviceSize toOffset = 0;
  VkDeviceSize bytes = 0;
  bool operator==(const CopyBuffer&) const = default;
};
struct CopyImage {
  bool toImage = false;  // else from it
  VkImage image = VK_NULL_HANDLE;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  VkImageAspectFlags aspect = 0;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t layer = 0;
  std::uint32_t level = 0;
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceSize offset = 0;
  bool operator==(const CopyImage&) const = default;
};
struct FillBuffer {
  VkBuffer buffer = VK_NULL_HANDLE;
  std::uint32_t value = 0;
  bool operator==(const FillBuffer&) const = default;
};
struct ClearImage {
  VkImage image = VK_NULL_HANDLE;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  bool operator==(const ClearImage&) const = default;
};

struct BuildStructure {
  enum class Part { Triangles, RefitTriangles, Bodies };
  AccelerationStructure* structure = nullptr;
  VkAccelerationStructureKHR handle = VK_NULL_HANDLE;  // a new structure may have the same address
  Part part = Part::Triangles;
  bool operator==(const BuildStructure&) const = default;
};

struct ResetQueries {
  VkQueryPool pool = VK_NULL_HANDLE;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  bool operator==(const ResetQueries&) const = default;
};
struct WriteTimestamp {
  VkQueryPool pool = VK_NULL_HANDLE;
  std::uint32_t query = 0;
  bool operator==(const WriteTimestamp&) const = default;
};
struct BeginLabel {
  const char* name = nullptr;  // a string literal
  bool operator==(const BeginLabel&) const = default;
};
struct EndLabel {
  bool operator==(const EndLabel&) const = default;
};

using Command =
    std::variant<Barriers, BindPipeline, BindResources, PushConstants, Dispatch, DispatchIndirect,
                 BeginRendering, EndRendering, Draw, DrawIndexed, CopyBuffer, CopyImage, FillBuffer,
                 ClearImage, BuildStructure, ResetQueries, WriteTimestamp, BeginLabel, EndLabel>;

}  // namespace tape

/// Commands before they are recorded with Vulkan. Equal tapes make the same command buffer, as long
/// as their handles mean the same objects. A tape that is reused for as many commands allocates
/// nothing.
class CommandTape {
 public:
  void clear();
  bool operator==(const CommandTape&) const = default;

  void add(const tape::Command& command) { commands_.push_back(command); }
  void add(const AccessBarrier& memory, std::span<const tape::ImageBarrier> images);
  void add(VkPipelineBindPoint point, VkPipelineLayout layout,
           std::span<const tape::Resource> resources);
  void add(VkPipelineLayout layout, VkShaderStageFlags stages,
           std::span<const std::byte> constants);
  void add(const tape::BeginRendering& begin, std::span<const tape::Target> targets);

  /// Records all commands. One command has at most maxResources resources, images or colour
  /// targets.
  static constexpr std::size_t maxResources = 32;
  void record(const Device& device, VkCommandBuffer to) const;

 private:
  std::vector<tape::Command> commands_;
  // Data of variable length, in the order of the commands.
  std::vector<tape::ImageBarrier> imageBarriers_;
  std::vector<tape::Resource> resources_;
  std::vector<std::byte> constants_;
  std::vector<tape::Target> targets_;
};

}  // namespace opaline::gpu
