#include "gpu/pipeline.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>

#include "gpu/device.h"
#include "gpu/device_choice.h"
#include "gpu/host_room.h"
#include "gpu/vulkan_result.h"
#include "opaline/error.h"

namespace opaline::gpu {

namespace {

// local_size_x_id in shaders/lib/work_group.glsl, constant_id in lib/lanes.glsl, local_size_x_id in
// shade/sky_blocks.comp.glsl.
constexpr std::uint32_t firstWorkGroupId = 16;

/// The values of constant_id 0, 1, 2, … and the sizes of work groups chosen for the device. It must
/// outlive the pipeline's creation.
class Specialization {
 public:
  Specialization(const Device& device, std::span<const std::byte> values)
      : values_(values.begin(), values.end()) {
    const auto count = static_cast<std::uint32_t>(values.size() / 4);
    for (std::uint32_t i = 0; i < count; ++i) entries_.push_back({i, i * 4, 4});
    const std::array groups{device.workGroups().invocations,
                            device.workGroups().invocationsOfLongWork, device.workGroups().lanes,
                            device.workGroups().invocationsOfRays,
                            device.workGroups().invocationsOfTile};
    const std::span<const std::byte> more = std::as_bytes(std::span(groups));
    values_.insert(values_.end(), more.begin(), more.end());
    for (std::uint32_t i = 0; i < groups.size(); ++i)
      entries_.push_back({firstWorkGroupId + i, (count + i) * 4, 4});
    info_ = {static_cast<std::uint32_t>(entries_.size()), entries_.data(), values_.size(),
             values_.data()};
  }
  ~Specialization() = default;
  Specialization(const Specialization&) = delete;
  Specialization& operator=(const Specialization&) = delete;
  const VkSpecializationInfo* info() const { return &info_; }

 private:
  std::vector<std::byte> values_;
  std::vector<VkSpecializationMapEntry> entries_;
  VkSpecializationInfo info_{};
};

/// A shader module that lives as long as the creation of its pipeline.
class ShaderModule {
 public:
  ShaderModule(const Device& device, std::span<const std::uint32_t> code, const std::string& name)
      : device_(device) {
    VkShaderModuleCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    info.codeSize = code.size_bytes();
    info.pCode = code.data();
    check(device.vk().vkCreateShaderModule(device.handle(), &info, nullptr, &module_),
          fmt::format("load a shader of \"{}\"", name));
    device.setName(VK_OBJECT_TYPE_SHADER_MODULE, reinterpret_cast<std::uint64_t>(module_), name);
  }
  ~ShaderModule() { device_.vk().vkDestroyShaderModule(device_.handle(), module_, nullptr); }
  ShaderModule(const ShaderModule&) = delete;
  ShaderModule& operator=(const ShaderModule&) = delete;

  VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits stage,
                                        const Specialization& specialization) const {
    VkPipelineShaderStageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage = stage;
    info.module = module_;
    info.pName = "main";
    info.pSpecializationInfo = specialization.info();
    return info;
  }

 private:
  const Device& device_;
  VkShaderModule module_ = VK_NULL_HANDLE;
};

VkPipelineRasterizationStateCreateInfo rasterizationOf(CullMode cull) {
  VkPipelineRasterizationStateCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
  info.polygonMode = VK_POLYGON_MODE_FILL;
  info.cullMode = cull == CullMode::Back    ? VK_CULL_MODE_BACK_BIT
                  : cull == CullMode::Front ? VK_CULL_MODE_FRONT_BIT
                                            : VK_CULL_MODE_NONE;
  // Vulkan's sign of area already accounts for y pointing down, so this is counter-clockwise as
  // seen.
  info.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
  info.lineWidth = 1.0F;
  return info;
}

VkCompareOp compareOf(DepthMode mode) {
  switch (mode) {
    case DepthMode::TestEqual:
      return VK_COMPARE_OP_EQUAL;
    case DepthMode::Test:
    case DepthMode::WriteOrEqual:
      return VK_COMPARE_OP_GREATER_OR_EQUAL;
    case DepthMode::WriteOrEqualOrdinary:
      return VK_COMPARE_OP_LESS_OR_EQUAL;
    case DepthMode::Off:
    case DepthMode::Write:
      break;
  }
  return VK_COMPARE_OP_GREATER;
}

VkPipelineDepthStencilStateCreateInfo depthOf(DepthMode mode) {
  VkPipelineDepthStencilStateCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
  info.depthTestEnable = mode != DepthMode::Off ? VK_TRUE : VK_FALSE;
  const bool writes = mode == DepthMode::Write || mode == DepthMode::WriteOrEqual ||
                      mode == DepthMode::WriteOrEqualOrdinary;
  info.depthWriteEnable = writes ? VK_TRUE : VK_FALSE;
  info.depthCompareOp = compareOf(mode);
  return info;
}

VkPipelineColorBlendAttachmentState blendOf(Blend mode) {
  VkPipelineColorBlendAttachmentState blend{};
  blend.blendEnable = mode == Blend::Over ? VK_TRUE : VK_FALSE;
  blend.srcColorBlendFactor = blend.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
  blend.dstColorBlendFactor = blend.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
  blend.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                         VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  return blend;
}

VkPipeline createCompute(const Device& device, const std::string& name, const Shader& shader,
                         std::span<const std::byte> constants, VkPipelineLayout layout) {
  const Specialization specialization(device, constants);
  const ShaderModule module(device, shader.words, name);
  VkComputePipelineCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
  info.stage = module.stage(VK_SHADER_STAGE_COMPUTE_BIT, specialization);
  info.layout = layout;
  info.flags = VK_PIPELINE_CREATE_DISPATCH_BASE_BIT;  // see CommandList::dispatchLinear
  VkPipeline pipeline = VK_NULL_HANDLE;
  requireHostRoom(roomToCompile, fmt::format("create the pipeline \"{}\"", name));
  check(device.vk().vkCreateComputePipelines(device.handle(), device.pipelineCacheHandle(), 1,
                                             &info, nullptr, &pipeline),
        fmt::format("create the pipeline \"{}\"", name));
  return pipeline;
}

VkPipeline createGraphics(const Device& device, const std::string& name, const Shader& vertex,
                          const Shader& fragment, const GraphicsOptions& options,
                          std::span<const std::byte> constants, VkPipelineLayout layout) {
  const Specialization specialization(device, constants);
  const ShaderModule vertexModule(device, vertex.words, name);
  std::vector<VkPipelineShaderStageCreateInfo> stages{
      vertexModule.stage(VK_SHADER_STAGE_VERTEX_BIT, specialization)};
  std::optional<ShaderModule> fragmentModule;
  if (!fragment.words.empty()) {
    fragmentModule.emplace(device, fragment.words, name);
    stages.push_back(fragmentModule->stage(VK_SHADER_STAGE_FRAGMENT_BIT, specialization));
  }
  const auto colors = static_cast<std::uint32_t>(options.colorFormats.size());
  VkPipelineRenderingCreateInfo rendering{};
  rendering.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
  rendering.colorAttachmentCount = colors;
  rendering.pColorAttachmentFormats = options.colorFormats.data();
  rendering.depthAttachmentFormat = options.depthFormat;

  VkPipelineVertexInputStateCreateInfo vertices{};
  vertices.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
  VkPipelineInputAssemblyStateCreateInfo assembly{};
  assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkPipelineViewportStateCreateInfo viewport{};
  viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
  viewport.viewportCount = 1;
  viewport.scissorCount = 1;
  const VkPipelineRasterizationStateCreateInfo rasterization = rasterizationOf(options.cull);
  VkPipelineMultisampleStateCreateInfo samples{};
  samples.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
  samples.rasterizationSamples = options.samples;
  const VkPipelineDepthStencilStateCreateInfo depth = depthOf(options.depth);
  std::array<VkPipelineColorBlendAttachmentState, maxColors> blends;
  blends.fill(blendOf(options.blend));
  VkPipelineColorBlendStateCreateInfo blending{};
  blending.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
  blending.attachmentCount = colors;
  blending.pAttachments = blends.data();
  const VkDynamicState dynamicStates[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  VkPipelineDynamicStateCreateInfo dynamic{};
  dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
  dynamic.dynamicStateCount = 2;
  dynamic.pDynamicStates = dynamicStates;

  VkGraphicsPipelineCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
  info.pNext = &rendering;
  info.stageCount = static_cast<std::uint32_t>(stages.size());
  info.pStages = stages.data();
  info.pVertexInputState = &vertices;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &rasterization;
  info.pMultisampleState = &samples;
  info.pDepthStencilState = &depth;
  info.pColorBlendState = &blending;
  info.pDynamicState = &dynamic;
  info.layout = layout;
  VkPipeline pipeline = VK_NULL_HANDLE;
  requireHostRoom(roomToCompile, fmt::format("create the pipeline \"{}\"", name));
  check(device.vk().vkCreateGraphicsPipelines(device.handle(), device.pipelineCacheHandle(), 1,
                                              &info, nullptr, &pipeline),
        fmt::format("create the pipeline \"{}\"", name));
  return pipeline;
}

}  // namespace

VkDescriptorType descriptorTypeOf(BindingType type) {
  switch (type) {
    case BindingType::UniformBuffer:
      return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    case BindingType::StorageBuffer:
      return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    case BindingType::TexelBuffer:
      return VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
    case BindingType::SampledImage:
      return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    case BindingType::StorageImage:
      return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    case BindingType::AccelerationStructure:
      return VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR;
  }
  assert(false);
  return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
}

/// The device's compiled pipeline, which is made once, by the first thread that needs it.
class Pipeline::Compiled {
 public:
  Compiled(Device& device, std::string name, std::function<VkPipeline()> compile)
      : device_(device), name_(std::move(name)), compile_(std::move(compile)) {}
  ~Compiled() { device_.retire(VK_OBJECT_TYPE_PIPELINE, pipeline_); }
  Compiled(const Compiled&) = delete;
  Compiled& operator=(const Compiled&) = delete;

  VkPipeline handle() {
    std::call_once(compiled_, [this] {
      pipeline_ = compile_();
      device_.setName(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<std::uint64_t>(pipeline_), name_);
    });
    return pipeline_;
  }

 private:
  Device& device_;
  std::string name_;
  std::function<VkPipeline()> compile_;
  std::once_flag compiled_;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
};

Pipeline::Pipeline(Device& device, const std::string& name, const Shader& shader,
                   std::span<const std::byte> constants)
    : Pipeline() {
  device_ = &device;
  bindPoint_ = VK_PIPELINE_BIND_POINT_COMPUTE;
  createLayout(name, {&shader, 1});
  const std::vector<std::byte> kept(constants.begin(), constants.end());
  compiled_ = std::make_unique<Compiled>(device, name, [=, &device, layout = layout_] {
    return createCompute(device, name, shader, kept, layout);
  });
}

Pipeline::Pipeline(Device& device, const std::string& name, const Shader& vertex,
                   const Shader& fragment, const GraphicsOptions& options,
                   std::span<const std::byte> constants)
    : Pipeline() {
  assert(options.depth == DepthMode::Off || options.depthFormat != VK_FORMAT_UNDEFINED);
  assert(options.colorFormats.size() <= maxColors);
  if (options.colorFormats.size() > device.limits().maxColorAttachments) {
    throw Error(fmt::format("the pass \"{}\" draws into {} targets at once, but {} can do {}", name,
                            options.colorFormats.size(), device.info().name,
                            device.limits().maxColorAttachments));
  }
  device_ = &device;
  bindPoint_ = VK_PIPELINE_BIND_POINT_GRAPHICS;
  const std::array shaders{vertex, fragment};
  createLayout(name, shaders);
  const std::vector<std::byte> kept(constants.begin(), constants.end());
  compiled_ = std::make_unique<Compiled>(device, name, [=, &device, layout = layout_] {
    return createGraphics(device, name, vertex, fragment, options, kept, layout);
  });
}

ShaderVariant variantOf(const Device& device) {
  return device.shaderVariant();
}

VkPipeline Pipeline::handle() const {
  return compiled_->handle();
}

void Pipeline::createLayout(const std::string& name, std::span<const Shader> shaders) {
  std::vector<VkDescriptorSetLayoutBinding> slots;
  for (const Shader& shader : shaders) {
    pushConstantBytes_ = std::max(pushConstantBytes_, shader.pushConstantBytes);
    for (const BindingSlot& slot : shader.slots) {
      const VkDescriptorType type = descriptorTypeOf(slot.type);
      assert(slot.binding < 32);
      if (hasSlot(slot.binding)) {
        assert(std::any_of(slots.begin(), slots.end(), [&](const auto& other) {
          return other.binding == slot.binding && other.descriptorType == type;
        }));
        continue;
      }
      slots_ |= 1U << slot.binding;
      if (slot.type == BindingType::StorageBuffer) storage_ |= 1U << slot.binding;
      slots.push_back({slot.binding, type, 1, stages(), nullptr});
    }
  }
  assert(pushConstantBytes_ <= 128 && pushConstantBytes_ % 4 == 0);
  assert(std::count_if(slots.begin(), slots.end(),
                       [](const auto& slot) {
                         return slot.descriptorType == VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
                       }) <= (device_->shaderVariant() == ShaderVariant::Texels
                                  ? storageBuffersOfStage
                                  : storageBuffersForTexels));
  VkDescriptorSetLayoutCreateInfo setInfo{};
  setInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  setInfo.flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR;
  setInfo.bindingCount = static_cast<std::uint32_t>(slots.size());
  setInfo.pBindings = slots.data();
  check(
      device_->vk().vkCreateDescriptorSetLayout(device_->handle(), &setInfo, nullptr, &setLayout_),
      fmt::format("create the bindings of \"{}\"", name));
  device_->setName(VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT,
                   reinterpret_cast<std::uint64_t>(setLayout_), name);

  const VkPushConstantRange range{stages(), 0, pushConstantBytes_};
  VkPipelineLayoutCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  info.setLayoutCount = 1;
  info.pSetLayouts = &setLayout_;
  info.pushConstantRangeCount = pushConstantBytes_ > 0 ? 1 : 0;
  info.pPushConstantRanges = &range;
  check(device_->vk().vkCreatePipelineLayout(device_->handle(), &info, nullptr, &layout_),
        fmt::format("create the layout of \"{}\"", name));
  device_->setName(VK_OBJECT_TYPE_PIPELINE_LAYOUT, reinterpret_cast<std::uint64_t>(layout_), name);
}

VkShaderStageFlags Pipeline::stages() const {
  return bindPoint_ == VK_PIPELINE_BIND_POINT_COMPUTE
             ? VkShaderStageFlags{VK_SHADER_STAGE_COMPUTE_BIT}
             : VkShaderStageFlags{VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT};
}

Pipeline::~Pipeline() {
  if (device_ == nullptr) return;
  compiled_.reset();
  device_->retire(VK_OBJECT_TYPE_PIPELINE_LAYOUT, layout_);
  device_->retire(VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT, setLayout_);
}

Pipeline::Pipeline(Pipeline&& other) noexcept {
  swap(other);
}

Pipeline& Pipeline::operator=(Pipeline&& other) noexcept {
  Pipeline taken(std::move(other));
  swap(taken);
  return *this;
}

void Pipeline::swap(Pipeline& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(setLayout_, other.setLayout_);
  std::swap(layout_, other.layout_);
  std::swap(compiled_, other.compiled_);
  std::swap(bindPoint_, other.bindPoint_);
  std::swap(pushConstantBytes_, other.pushConstantBytes_);
  std::swap(slots_, other.slots_);
}

}  // namespace opaline::gpu
