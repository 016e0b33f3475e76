#include "gpu/command_tape.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "gpu/acceleration_structure.h"
#include "gpu/device.h"
#include "gpu/pipeline.h"

namespace opaline::gpu {

namespace {

using namespace tape;

template <typename T>
void append(std::vector<T>& to, std::span<const T> what) {
  to.insert(to.end(), what.begin(), what.end());
}

VkImageMemoryBarrier2 barrierOf(const ImageBarrier& barrier) {
  VkImageMemoryBarrier2 out{};
  out.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
  out.srcStageMask = barrier.access.fromStages;
  out.srcAccessMask = barrier.access.fromAccesses;
  out.dstStageMask = barrier.access.toStages;
  out.dstAccessMask = barrier.access.toAccesses;
  out.oldLayout = barrier.access.oldLayout;
  out.newLayout = barrier.access.newLayout;
  out.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  out.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  out.image = barrier.image;
  out.subresourceRange = {barrier.aspect, 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS};
  return out;
}

VkRenderingAttachmentInfo attachmentOf(const Target& target) {
  VkRenderingAttachmentInfo info{};
  info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
  info.imageView = target.view;
  info.imageLayout = target.layout;
  info.loadOp = target.clear ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
  info.storeOp = target.write ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_NONE;
  // For a depth target only the first number counts, which is at the same place as a colour's.
  std::copy(target.clearBits.begin(), target.clearBits.end(),
            std::begin(info.clearValue.color.uint32));
  return info;
}

// Records the commands of a tape one by one.
class Recorder {
 public:
  Recorder(const Device& device, VkCommandBuffer to, const ImageBarrier* imageBarriers,
           const Resource* resources, const std::byte* constants, const Target* targets)
      : device_(device),
        vk_(device.vk()),
        to_(to),
        imageBarriers_(imageBarriers),
        resources_(resources),
        constants_(constants),
        targets_(targets) {}

  void operator()(const Barriers& barriers) {
    VkMemoryBarrier2 memory{};
    memory.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
    memory.srcStageMask = barriers.memory.fromStages;
    memory.srcAccessMask = barriers.memory.fromAccesses;
    memory.dstStageMask = barriers.memory.toStages;
    memory.dstAccessMask = barriers.memory.toAccesses;
    std::array<VkImageMemoryBarrier2, CommandTape::maxResources> images;
    for (std::uint32_t i = 0; i < barriers.images; ++i) images[i] = barrierOf(*imageBarriers_++);
    VkDependencyInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    info.memoryBarrierCount = memory.dstStageMask != 0 ? 1 : 0;
    info.pMemoryBarriers = &memory;
    info.imageMemoryBarrierCount = barriers.images;
    info.pImageMemoryBarriers = images.data();
    vk_.vkCmdPipelineBarrier2(to_, &info);
  }

  void operator()(const BindPipeline& bind) {
    vk_.vkCmdBindPipeline(to_, bind.point, bind.pipeline);
  }

  void operator()(const BindResources& bind) {
    constexpr std::size_t most = CommandTape::maxResources;
    std::array<VkWriteDescriptorSet, most> writes;
    std::array<VkDescriptorBufferInfo, most> buffers;
    std::array<VkDescriptorImageInfo, most> images;
    std::array<VkWriteDescriptorSetAccelerationStructureKHR, most> structures;
    for (std::uint32_t i = 0; i < bind.resources; ++i) {
      const Resource& resource = *resources_++;
      buffers[i] = {resource.buffer, resource.offset, resource.range};
      images[i] = {resource.sampler, resource.view, resource.imageLayout};
      structures[i] = {};
      structures[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET_ACCELERATION_STRUCTURE_KHR;
      structures[i].accelerationStructureCount = 1;
      structures[i].pAccelerationStructures = &resource.structure;
      writes[i] = {};
      writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
      if (resource.structure != VK_NULL_HANDLE) writes[i].pNext = &structures[i];
      writes[i].dstBinding = resource.slot;
      writes[i].descriptorCount = 1;
      writes[i].descriptorType = resource.type;
      writes[i].pBufferInfo = &buffers[i];
      writes[i].pImageInfo = &images[i];
      writes[i].pTexelBufferView = &resource.texels;
    }
    vk_.vkCmdPushDescriptorSetKHR(to_, bind.point, bind.layout, 0, bind.resources, writes.data());
  }

  void operator()(const PushConstants& push) {
    vk_.vkCmdPushConstants(to_, push.layout, push.stages, 0, push.bytes, constants_);
    constants_ += push.bytes;
  }

  void operator()(const Dispatch& dispatch) {
    vk_.vkCmdDispatchBase(to_, 0, dispatch.firstRow, 0, dispatch.groupsX, dispatch.groupsY,
                          dispatch.groupsZ);
  }

  void operator()(const DispatchIndirect& dispatch) {
    vk_.vkCmdDispatchIndirect(to_, dispatch.groups, dispatch.offset);
  }

  void operator()(const BeginRendering& begin) {
    std::array<VkRenderingAttachmentInfo, maxColors> colors;
    for (std::uint32_t i = 0; i < begin.colors; ++i) colors[i] = attachmentOf(*targets_++);
    VkRenderingAttachmentInfo depth{};
    if (begin.depth) depth = attachmentOf(*targets_++);
    const VkRect2D area{{0, 0}, {begin.width, begin.height}};
    VkRenderingInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
    info.renderArea = area;
    info.layerCount = 1;
    info.colorAttachmentCount = begin.colors;
    info.pColorAttachments = colors.data();
    info.pDepthAttachment = begin.depth ? &depth : nullptr;
    vk_.vkCmdBeginRendering(to_, &info);
    const VkViewport viewport{
        0.0F, 0.0F, static_cast<float>(begin.width), static_cast<float>(begin.height), 0.0F, 1.0F};
    vk_.vkCmdSetViewport(to_, 0, 1, &viewport);
    vk_.vkCmdSetScissor(to_, 0, 1, &area);
  }

  void operator()(const EndRendering&) { vk_.vkCmdEndRendering(to_); }

  void operator()(const Draw& draw) { vk_.vkCmdDraw(to_, draw.vertices, 1, draw.firstVertex, 0); }

  void operator()(const DrawIndexed& draw) {
    vk_.vkCmdBindIndexBuffer(to_, draw.indices, 0, VK_INDEX_TYPE_UINT32);
    vk_.vkCmdDrawIndexed(to_, draw.count, 1, draw.firstIndex, 0, 0);
  }

  void operator()(const CopyBuffer& copy) {
    const VkBufferCopy region{copy.fromOffset, copy.toOffset, copy.bytes};
    vk_.vkCmdCopyBuffer(to_, copy.from, copy.to, 1, &region);
  }

  void operator()(const CopyImage& copy) {
    VkBufferImageCopy region{};
    region.bufferOffset = copy.offset;
    region.imageSubresource = {copy.aspect, copy.level, copy.layer, 1};
    region.imageExtent = {copy.width, copy.height, 1};
    if (copy.toImage)
      vk_.vkCmdCopyBufferToImage(to_, copy.buffer, copy.image, copy.layout, 1, &region);
    else
      vk_.vkCmdCopyImageToBuffer(to_, copy.image, copy.layout, copy.buffer, 1, &region);
  }

  void operator()(const FillBuffer& fill) {
    vk_.vkCmdFillBuffer(to_, fill.buffer, 0, VK_WHOLE_SIZE, fill.value);
  }

  void operator()(const ClearImage& clear) {
    const VkClearColorValue nothing{};
    const VkImageSubresourceRange whole{VK_IMAGE_ASPECT_COLOR_BIT, 0, VK_REMAINING_MIP_LEVELS, 0,
                                        VK_REMAINING_ARRAY_LAYERS};
    vk_.vkCmdClearColorImage(to_, clear.image, clear.layout, &nothing, 1, &whole);
  }

  void operator()(const BuildStructure& build) {
    using Part = BuildStructure::Part;
    if (build.part == Part::Bodies)
      build.structure->recordBodies(to_);
    else
      build.structure->recordTriangles(to_, build.part == Part::RefitTriangles);
  }

  void operator()(const ResetQueries& reset) {
    vk_.vkCmdResetQueryPool(to_, reset.pool, reset.first, reset.count);
  }

  void operator()(const WriteTimestamp& write) {
    vk_.vkCmdWriteTimestamp2(to_, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, write.pool, write.query);
  }

  void operator()(const BeginLabel& label) { device_.beginLabel(to_, label.name); }
  void operator()(const EndLabel&) { device_.endLabel(to_); }

 private:
  const Device& device_;
  const DeviceFunctions& vk_;
  VkCommandBuffer to_;
  // The next entries of the tape.
  const ImageBarrier* imageBarriers_;
  const Resource* resources_;
  const std::byte* constants_;
  const Target* targets_;
};

}  // namespace

void CommandTape::clear() {
  commands_.clear();
  imageBarriers_.clear();
  resources_.clear();
  constants_.clear();
  targets_.clear();
}

void CommandTape::add(const AccessBarrier& memory, std::span<const ImageBarrier> images) {
  assert(images.size() <= maxResources);
  commands_.push_back(Barriers{memory, static_cast<std::uint32_t>(images.size())});
  append(imageBarriers_, images);
}

void CommandTape::add(VkPipelineBindPoint point, VkPipelineLayout layout,
                      std::span<const Resource> resources) {
  assert(resources.size() <= maxResources);
  commands_.push_back(BindResources{point, layout, static_cast<std::uint32_t>(resources.size())});
  append(resources_, resources);
}

void CommandTape::add(VkPipelineLayout layout, VkShaderStageFlags stages,
                      std::span<const std::byte> constants) {
  commands_.push_back(PushConstants{layout, stages, static_cast<std::uint32_t>(constants.size())});
  append(constants_, constants);
}

void CommandTape::add(const BeginRendering& begin, std::span<const Target> targets) {
  assert(begin.colors <= maxColors && targets.size() == begin.colors + (begin.depth ? 1U : 0U));
  commands_.push_back(begin);
  append(targets_, targets);
}

void CommandTape::record(const Device& device, VkCommandBuffer to) const {
  Recorder recorder(device, to, imageBarriers_.data(), resources_.data(), constants_.data(),
                    targets_.data());
  for (const Command& command : commands_) std::visit(recorder, command);
}

}  // namespace opaline::gpu
