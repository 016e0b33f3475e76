#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "gpu/binding.h"
#include "gpu/shader.h"

namespace opaline::gpu {

class Device;

VkDescriptorType descriptorTypeOf(BindingType type);

/// The most targets that a pass draws into at once.
constexpr std::size_t maxColors = 8;

enum class CullMode { None, Front, Back };
enum class DepthMode {
  Off,
  Write,
  TestEqual,
  Test,
  WriteOrEqual,          ///< equal depth passes too
  WriteOrEqualOrdinary,  ///< the same for depth that is not reversed
};
enum class Blend {
  Off,
  Over,  ///< blends colours that are premultiplied by alpha
};

struct GraphicsOptions {
  std::vector<VkFormat> colorFormats;
  VkFormat depthFormat = VK_FORMAT_UNDEFINED;
  DepthMode depth = DepthMode::Off;  ///< reversed: Write passes nearer fragments
  Blend blend = Blend::Off;
  CullMode cull = CullMode::None;  ///< front is counter-clockwise as seen
  VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
};

/// A pipeline without vertex input (vertices are pulled from storage buffers), with dynamic
/// viewport, one push-descriptor set and push constants. The device compiles it when it is first
/// bound, so that a process pays only for the passes that it runs. Movable.
class Pipeline {
 public:
  Pipeline() = default;
  ~Pipeline();
  Pipeline(Pipeline&& other) noexcept;
  Pipeline& operator=(Pipeline&& other) noexcept;
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;

  explicit operator bool() const { return compiled_ != nullptr; }
  /// Throws Error when the device cannot compile it.
  VkPipeline handle() const;
  VkPipelineLayout layout() const { return layout_; }
  VkPipelineBindPoint bindPoint() const { return bindPoint_; }
  VkShaderStageFlags stages() const;  ///< those that see the bindings and push constants
  std::uint32_t pushConstantBytes() const { return pushConstantBytes_; }
  bool hasSlot(std::uint32_t slot) const { return slot < 32 && (slots_ >> slot & 1U) != 0; }
  /// Whether a slot is a storage buffer in the shader's variant.
  bool isStorage(std::uint32_t slot) const { return slot < 32 && (storage_ >> slot & 1U) != 0; }

 protected:
  /// `constants`: values of constant_id 0, 1, 2, …, four bytes each, of all stages.
  Pipeline(Device& device, const std::string& name, const Shader& shader,
           std::span<const std::byte> constants);
  /// A fragment shader without words counts as none.
  Pipeline(Device& device, const std::string& name, const Shader& vertex, const Shader& fragment,
           const GraphicsOptions& options, std::span<const std::byte> constants);

 private:
  class Compiled;

  void createLayout(const std::string& name, std::span<const Shader> shaders);
  void swap(Pipeline& other) noexcept;

  Device* device_ = nullptr;
  VkDescriptorSetLayout setLayout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  std::unique_ptr<Compiled> compiled_;
  VkPipelineBindPoint bindPoint_ = VK_PIPELINE_BIND_POINT_COMPUTE;
  std::uint32_t pushConstantBytes_ = 0;
  std::uint32_t slots_ = 0;    // bit n: binding n exists
  std::uint32_t storage_ = 0;  // bit n: it is a storage buffer
};

/// The variant that a device's pipelines are made from.
ShaderVariant variantOf(const Device& device);

template <typename Constants>
std::span<const std::byte> wordsOf(const Constants& constants) {
  if constexpr (std::is_empty_v<Constants>)
    return {};
  else
    return std::as_bytes(std::span(&constants, 1));
}

/// A pipeline of the compute shader S; see gpu/shader.h.
template <typename S>
class Compute : public Pipeline {
 public:
  Compute(Device& device, const std::string& name, const typename S::Constants& constants = {})
      : Pipeline(device, name, S::shader(variantOf(device)), wordsOf(constants)) {}
};

/// A pipeline of the vertex shader V and the fragment shader F, which has the constants.
template <typename V, typename F = NoFragment>
class Graphics : public Pipeline {
 public:
  static_assert(std::is_empty_v<typename V::Constants>);
  static_assert(std::is_empty_v<typename V::Push> || std::is_empty_v<typename F::Push>);
  using Push =
      std::conditional_t<std::is_empty_v<typename V::Push>, typename F::Push, typename V::Push>;

  Graphics(Device& device, const std::string& name, const GraphicsOptions& options,
           const typename F::Constants& constants = {})
      : Pipeline(device, name, V::shader(variantOf(device)), F::shader(variantOf(device)), options,
                 wordsOf(constants)) {}
};

}  // namespace opaline::gpu
