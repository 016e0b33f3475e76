#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace opaline::gpu {

class Device;

/// A compiled shader, embedded in the program (see shaders/shaders.h).
using Spirv = std::span<const std::uint32_t>;

/// A TexelBuffer is read four floats at a time by texelFetch (samplerBuffer), which some devices do
/// faster than reading storage buffers.
enum class BindingType {
  UniformBuffer,
  StorageBuffer,
  TexelBuffer,
  SampledImage,
  StorageImage,
  AccelerationStructure
};

VkDescriptorType descriptorTypeOf(BindingType type);

/// `binding` of set 0, below 32, visible to every stage.
struct BindingSlot {
  std::uint32_t binding = 0;
  BindingType type = BindingType::StorageBuffer;
};

struct ComputePipelineOptions {
  std::string name;
  Spirv shader;
  std::vector<BindingSlot> bindings;
  std::uint32_t pushConstantBytes = 0;        ///< at most 128
  std::vector<std::uint32_t> specialization;  ///< value of constant_id 0, 1, 2, …
};

/// Targets that a pass draws into at once.
constexpr std::size_t maxColors = 8;

enum class CullMode { None, Front, Back };
enum class DepthMode { Off, Write, TestEqual, Test };

struct GraphicsPipelineOptions {
  std::string name;
  Spirv vertexShader;
  Spirv fragmentShader;  ///< may be empty: depth only
  std::vector<BindingSlot> bindings;
  std::uint32_t pushConstantBytes = 0;        ///< at most 128
  std::vector<std::uint32_t> specialization;  ///< of both stages
  std::vector<VkFormat> colorFormats;
  VkFormat depthFormat = VK_FORMAT_UNDEFINED;
  DepthMode depth = DepthMode::Off;  ///< reversed depth: Write passes what is nearer
  CullMode cull = CullMode::None;    ///< front is counter-clockwise as seen
  bool additive = false;             ///< colour is added to what is there
};

/// A pipeline without vertex input (vertices are pulled from storage buffers), with dynamic
/// viewport, one push-descriptor set and push constants. Movable.
class Pipeline {
 public:
  Pipeline() = default;
  Pipeline(Device& device, const ComputePipelineOptions& options);
  Pipeline(Device& device, const GraphicsPipelineOptions& options);
  ~Pipeline();
  Pipeline(Pipeline&& other) noexcept;
  Pipeline& operator=(Pipeline&& other) noexcept;
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;

  explicit operator bool() const { return pipeline_ != VK_NULL_HANDLE; }
  VkPipeline handle() const { return pipeline_; }
  VkPipelineLayout layout() const { return layout_; }
  VkPipelineBindPoint bindPoint() const { return bindPoint_; }
  VkShaderStageFlags stages() const;  ///< those that see the bindings and push constants
  std::uint32_t pushConstantBytes() const { return pushConstantBytes_; }
  bool hasSlot(std::uint32_t slot) const { return slot < 32 && (slots_ >> slot & 1U) != 0; }

 private:
  void createLayout(const std::string& name, std::span<const BindingSlot> bindings,
                    std::uint32_t pushConstantBytes);
  void swap(Pipeline& other) noexcept;

  Device* device_ = nullptr;
  VkDescriptorSetLayout setLayout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  VkPipelineBindPoint bindPoint_ = VK_PIPELINE_BIND_POINT_COMPUTE;
  std::uint32_t pushConstantBytes_ = 0;
  std::uint32_t slots_ = 0;  // bit n: binding n is there
};

}  // namespace opaline::gpu
