#include "viewer/picture/picture_painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "shaders/picture.frag.h"
#include "shaders/picture.vert.h"
#include "viewer/window/vulkan_check.h"

namespace opaline::app::viewer {

namespace {

using Constants = shaders::PictureFrag::Push;

VkShaderModule makeModule(VkDevice device, std::span<const std::uint32_t> words) {
  VkShaderModuleCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  info.codeSize = words.size_bytes();
  info.pCode = words.data();
  VkShaderModule module = VK_NULL_HANDLE;
  check(vkCreateShaderModule(device, &info, nullptr, &module), "prepare its drawing");
  return module;
}

VkPipelineShaderStageCreateInfo stageOf(VkShaderStageFlagBits stage, VkShaderModule module) {
  VkPipelineShaderStageCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage = stage;
  info.module = module;
  info.pName = "main";
  return info;
}

}  // namespace

Area fitted(const Area& area, int width, int height) {
  const double scale =
      std::min(static_cast<double>(area.width) / width, static_cast<double>(area.height) / height);
  const int w = std::max(1, static_cast<int>(scale * width));
  const int h = std::max(1, static_cast<int>(scale * height));
  return {area.x + (area.width - w) / 2, area.y + (area.height - h) / 2, w, h};
}

PicturePainter::PicturePainter(const VulkanDevice& device, VkRenderPass renderPass)
    : device_(device),
      pushDescriptorSet_(reinterpret_cast<PFN_vkCmdPushDescriptorSetKHR>(
          vkGetDeviceProcAddr(device.device, "vkCmdPushDescriptorSetKHR"))) {
  makeLayout();
  makePipeline(renderPass);
}

PicturePainter::~PicturePainter() {
  vkDestroyPipeline(device_.device, pipeline_, nullptr);
  vkDestroyPipelineLayout(device_.device, layout_, nullptr);
  vkDestroyDescriptorSetLayout(device_.device, sets_, nullptr);
  vkDestroySampler(device_.device, sampler_, nullptr);
}

void PicturePainter::makeLayout() {
  VkSamplerCreateInfo sampler{};
  sampler.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
  check(vkCreateSampler(device_.device, &sampler, nullptr, &sampler_), "prepare its drawing");
  VkDescriptorSetLayoutBinding binding{};
  binding.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
  binding.descriptorCount = 1;
  binding.stageFlags = VK_SHADER_STAGE_FRAGMENT_BIT;
  VkDescriptorSetLayoutCreateInfo sets{};
  sets.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  sets.flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR;
  sets.bindingCount = 1;
  sets.pBindings = &binding;
  check(vkCreateDescriptorSetLayout(device_.device, &sets, nullptr, &sets_), "prepare its drawing");
  const VkPushConstantRange constants{VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof(Constants)};
  VkPipelineLayoutCreateInfo layout{};
  layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  layout.setLayoutCount = 1;
  layout.pSetLayouts = &sets_;
  layout.pushConstantRangeCount = 1;
  layout.pPushConstantRanges = &constants;
  check(vkCreatePipelineLayout(device_.device, &layout, nullptr, &layout_), "prepare its drawing");
}

void PicturePainter::makePipeline(VkRenderPass renderPass) {
  const VkShaderModule vertex = makeModule(device_.device, shaders::PictureVert::shader().words);
  const VkShaderModule fragment = makeModule(device_.device, shaders::PictureFrag::shader().words);
  const std::array stages{stageOf(VK_SHADER_STAGE_VERTEX_BIT, vertex),
                          stageOf(VK_SHADER_STAGE_FRAGMENT_BIT, fragment)};
  VkPipelineVertexInputStateCreateInfo input{};
  input.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
  VkPipelineInputAssemblyStateCreateInfo assembly{};
  assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkPipelineViewportStateCreateInfo viewport{};
  viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
  viewport.viewportCount = 1;
  viewport.scissorCount = 1;
  VkPipelineRasterizationStateCreateInfo raster{};
  raster.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
  raster.lineWidth = 1;
  VkPipelineMultisampleStateCreateInfo samples{};
  samples.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
  samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineColorBlendAttachmentState write{};
  write.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                         VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  VkPipelineColorBlendStateCreateInfo blend{};
  blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
  blend.attachmentCount = 1;
  blend.pAttachments = &write;
  const std::array dynamic{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  VkPipelineDynamicStateCreateInfo state{};
  state.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
  state.dynamicStateCount = static_cast<std::uint32_t>(dynamic.size());
  state.pDynamicStates = dynamic.data();

  VkGraphicsPipelineCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
  info.stageCount = static_cast<std::uint32_t>(stages.size());
  info.pStages = stages.data();
  info.pVertexInputState = &input;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &raster;
  info.pMultisampleState = &samples;
  info.pColorBlendState = &blend;
  info.pDynamicState = &state;
  info.layout = layout_;
  info.renderPass = renderPass;
  const VkResult result =
      vkCreateGraphicsPipelines(device_.device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_);
  vkDestroyShaderModule(device_.device, vertex, nullptr);
  vkDestroyShaderModule(device_.device, fragment, nullptr);
  check(result, "prepare its drawing");
}

void PicturePainter::draw(VkCommandBuffer commands, const DeviceImage& picture, const Area& place,
                          const Area& visible, const ToneOptions& tone) const {
  if (visible.empty() || place.empty() || picture.view == VK_NULL_HANDLE) return;
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
  const VkViewport viewport{static_cast<float>(visible.x),
                            static_cast<float>(visible.y),
                            static_cast<float>(visible.width),
                            static_cast<float>(visible.height),
                            0,
                            1};
  const VkRect2D scissor{
      {visible.x, visible.y},
      {static_cast<std::uint32_t>(visible.width), static_cast<std::uint32_t>(visible.height)}};
  vkCmdSetViewport(commands, 0, 1, &viewport);
  vkCmdSetScissor(commands, 0, 1, &scissor);
  const VkDescriptorImageInfo image{sampler_, picture.view, picture.layout};
  VkWriteDescriptorSet write{};
  write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
  write.descriptorCount = 1;
  write.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
  write.pImageInfo = &image;
  pushDescriptorSet_(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 1, &write);

  const Rgb behind = tone.background.value_or(Rgb{0, 0, 0});
  const auto shown = [&](std::size_t c) { return std::clamp(behind[c], 0.0F, 1.0F); };
  const bool neutral = tone.curve == ToneCurve::Neutral;
  const Constants constants{.background = glm::vec4(shown(0), shown(1), shown(2), neutral ? 1 : 0),
                            .origin = glm::vec2(place.x, place.y),
                            .pixels = glm::vec2(place.width, place.height),
                            .exposure = std::exp2(tone.exposureStops)};
  vkCmdPushConstants(commands, layout_, VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof(constants),
                     &constants);
  vkCmdDraw(commands, 3, 1, 0, 0);
}

}  // namespace opaline::app::viewer
