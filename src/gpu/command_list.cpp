#include "gpu/command_list.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "gpu/acceleration_structure.h"
#include "gpu/device.h"
#include "gpu/vulkan_result.h"

namespace opaline::gpu {

namespace {

VkDescriptorBufferInfo bufferInfoOf(const Binding& binding, const VkPhysicalDeviceLimits& limits) {
  assert(binding.offset < binding.buffer->bytes());
  const std::size_t rest = binding.buffer->bytes() - binding.offset;
  assert(binding.bytes <= rest);
  VkDeviceSize range = binding.bytes == 0 ? rest : binding.bytes;
  if (binding.type == BindingType::UniformBuffer && binding.bytes == 0) {
    range = std::min<VkDeviceSize>(range, limits.maxUniformBufferRange);
  }
  return {binding.buffer->handle(), binding.offset, range};
}

bool sameResource(const Binding& a, const Binding& b) {
  return a.buffer == b.buffer && a.image == b.image;
}

AccessScope bindingScope(const Binding& binding) {
  AccessScope scope = scopeOf(binding.access);
  if (binding.buffer != nullptr) scope.layout = VK_IMAGE_LAYOUT_UNDEFINED;
  return scope;
}

}  // namespace

CommandList::CommandList(Device& device, std::string name, std::uint32_t maxPasses)
    : device_(device), name_(std::move(name)), timer_(device, name_, maxPasses) {
  VkCommandPoolCreateInfo poolInfo{};
  poolInfo.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  poolInfo.queueFamilyIndex = device.queueFamily();
  VkResult result = vkCreateCommandPool(device.handle(), &poolInfo, nullptr, &pool_);
  if (result >= 0) {
    VkCommandBufferAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    info.commandPool = pool_;
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = 1;
    result = vkAllocateCommandBuffers(device.handle(), &info, &commands_);
  }
  if (result < 0) {
    vkDestroyCommandPool(device.handle(), pool_, nullptr);
    check(result, fmt::format("create the command list \"{}\"", name_));
  }
  device.setName(VK_OBJECT_TYPE_COMMAND_POOL, reinterpret_cast<std::uint64_t>(pool_), name_);
  device.setName(VK_OBJECT_TYPE_COMMAND_BUFFER, reinterpret_cast<std::uint64_t>(commands_), name_);
}

CommandList::~CommandList() {
  device_.retire(VK_OBJECT_TYPE_COMMAND_POOL, pool_);
}

void CommandList::begin() {
  wait();
  check(vkResetCommandPool(device_.handle(), pool_, 0), "reset a command list");
  VkCommandBufferBeginInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(commands_, &info), "begin a command list");
  recording_ = true;
  counts_ = {};
  inPass_ = false;
  rendering_ = false;
  pipeline_ = nullptr;
  for (auto& slots : bound_) slots.fill({});
  timer_.reset();
}

void CommandList::submit() {
  assert(recording_ && !inPass_ && !rendering_);
  // Its name only where it fails: frames allocate nothing.
  const VkResult recorded = vkEndCommandBuffer(commands_);
  if (recorded < 0) check(recorded, fmt::format("record \"{}\"", name_));
  recording_ = false;
  submission_ = device_.submit(commands_);
}

void CommandList::wait() {
  if (submission_ == 0) return;
  device_.waitFor(submission_);
  submission_ = 0;
  timer_.collect();
}

void CommandList::beginPass(const char* name) {
  assert(recording_ && !inPass_ && !rendering_);
  timer_.begin(commands_, name);
  device_.beginLabel(commands_, name);
  inPass_ = true;
}

void CommandList::endPass() {
  assert(recording_ && inPass_);
  device_.endLabel(commands_);
  timer_.end(commands_);
  inPass_ = false;
}

const std::vector<PassTiming>& CommandList::timings() {
  return timer_.timings();
}

double CommandList::frameMilliseconds() {
  return timer_.frameMilliseconds();
}

void CommandList::order(Buffer& buffer, AccessScope scope) {
  scope.layout = VK_IMAGE_LAYOUT_UNDEFINED;
  const auto barrier = advance(buffer.state_, scope);
  if (!barrier) return;
  memoryBarrier_.srcStageMask |= barrier->fromStages;
  memoryBarrier_.srcAccessMask |= barrier->fromAccesses;
  memoryBarrier_.dstStageMask |= barrier->toStages;
  memoryBarrier_.dstAccessMask |= barrier->toAccesses;
}

void CommandList::order(GpuImage& image, const AccessScope& scope) {
  const auto barrier = advance(image.state_, scope);
  if (!barrier) return;
  assert(imageBarrierCount_ < imageBarriers_.size());
  VkImageMemoryBarrier2& out = imageBarriers_[imageBarrierCount_++];
  out = {};
  out.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
  out.srcStageMask = barrier->fromStages;
  out.srcAccessMask = barrier->fromAccesses;
  out.dstStageMask = barrier->toStages;
  out.dstAccessMask = barrier->toAccesses;
  out.oldLayout = barrier->oldLayout;
  out.newLayout = barrier->newLayout;
  out.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  out.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  out.image = image.handle();
  out.subresourceRange = {image.aspect(), 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS};
}

void CommandList::flushBarriers() {
  const bool memory = memoryBarrier_.dstStageMask != 0;
  if (!memory && imageBarrierCount_ == 0) return;
  assert(recording_);
  assert(!rendering_ && "a barrier inside a rendering scope: bind before beginRendering");
  memoryBarrier_.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
  VkDependencyInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
  info.memoryBarrierCount = memory ? 1 : 0;
  info.pMemoryBarriers = &memoryBarrier_;
  info.imageMemoryBarrierCount = imageBarrierCount_;
  info.pImageMemoryBarriers = imageBarriers_.data();
  ++counts_.barriers;
  vkCmdPipelineBarrier2(commands_, &info);
  memoryBarrier_ = {};
  imageBarrierCount_ = 0;
}

void CommandList::use(Buffer& buffer, Access access) {
  order(buffer, scopeOf(access));
  flushBarriers();
}

void CommandList::use(GpuImage& image, Access access) {
  order(image, scopeOf(access));
  flushBarriers();
}

void CommandList::bindPipeline(const Pipeline& pipeline) {
  assert(recording_ && pipeline);
  if (pipeline_ == &pipeline) return;
  pipeline_ = &pipeline;
  vkCmdBindPipeline(commands_, pipeline.bindPoint(), pipeline.handle());
}

void CommandList::orderBindings(std::span<const Binding> bindings) {
  for (std::size_t i = 0; i < bindings.size(); ++i) {
    const auto same = [&](const Binding& other) { return sameResource(other, bindings[i]); };
    const auto begin = bindings.begin();
    const auto here = begin + static_cast<std::ptrdiff_t>(i);
    if (std::any_of(begin, here, same)) continue;
    AccessScope scope = bindingScope(bindings[i]);
    for (auto other = here + 1; other != bindings.end(); ++other) {
      if (same(*other)) scope = together(scope, bindingScope(*other));
    }
    if (bindings[i].buffer != nullptr) {
      order(*bindings[i].buffer, scope);
    } else {
      order(*bindings[i].image, scope);
    }
  }
  flushBarriers();
}

void CommandList::bindResources(std::span<const Binding> bindings) {
  assert(recording_ && pipeline_ != nullptr && bindings.size() <= maxSlots);
  if (bindings.empty()) return;
  orderBindings(bindings);
  std::array<VkWriteDescriptorSet, maxSlots> writes;
  std::array<VkDescriptorBufferInfo, maxSlots> buffers;
  std::array<VkDescriptorImageInfo, maxSlots> images;
  std::array<VkBufferView, maxSlots> texels;
  std::array<VkWriteDescriptorSetAccelerationStructureKHR, maxSlots> structures;
  for (std::size_t i = 0; i < bindings.size(); ++i) {
    const Binding& binding = bindings[i];
    assert(pipeline_->hasSlot(binding.slot));
    VkWriteDescriptorSet& write = writes[i];
    write = {};
    write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    write.dstBinding = binding.slot;
    write.descriptorCount = 1;
    write.descriptorType = descriptorTypeOf(binding.type);
    if (binding.type == BindingType::TexelBuffer) {
      texels[i] = binding.buffer->texelView();
      write.pTexelBufferView = &texels[i];
    } else if (binding.type == BindingType::AccelerationStructure) {
      structures[i] = {};
      structures[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET_ACCELERATION_STRUCTURE_KHR;
      structures[i].accelerationStructureCount = 1;
      structures[i].pAccelerationStructures = &binding.structure;
      write.pNext = &structures[i];
    } else if (binding.buffer != nullptr) {
      buffers[i] = bufferInfoOf(binding, device_.limits());
      write.pBufferInfo = &buffers[i];
    } else {
      images[i] = {binding.sampler, binding.view, bindingScope(binding).layout};
      write.pImageInfo = &images[i];
    }
    bound_[pipeline_->bindPoint()][binding.slot] = binding;
  }
  device_.pushDescriptorSet()(commands_, pipeline_->bindPoint(), pipeline_->layout(), 0,
                              static_cast<std::uint32_t>(bindings.size()), writes.data());
}

/// Whether nothing that the pipeline reads or writes was used otherwise since it was bound, for
/// example became an attachment.
bool CommandList::boundIsCurrent() const {
  const auto& slots = bound_[pipeline_->bindPoint()];
  return std::all_of(slots.begin(), slots.end(), [&](const Binding& binding) {
    if (binding.access == Access::None || !pipeline_->hasSlot(binding.slot)) return true;
    const AccessState& state =
        binding.buffer != nullptr ? binding.buffer->state_ : binding.image->state_;
    const AccessScope scope = bindingScope(binding);
    return scope.layout == state.layout &&
           (scope.accesses & ~(state.readAccesses | state.writeAccesses)) == 0;
  });
}

void CommandList::build(AccelerationStructure& structure, Buffer& corners, bool refit) {
  assert(recording_ && !rendering_);
  order(corners, scopeOf(Access::RayInput));
  order(structure.storage_, scopeOf(Access::RayBuild));
  order(structure.scratch_, scopeOf(Access::RayBuild));
  flushBarriers();
  structure.recordTriangles(commands_, refit);
  order(structure.storage_, scopeOf(Access::RayBuild));
  flushBarriers();
  structure.recordBodies(commands_);
}

void CommandList::pushBytes(const void* data, std::uint32_t bytes) {
  assert(bytes == pipeline_->pushConstantBytes());
  vkCmdPushConstants(commands_, pipeline_->layout(), pipeline_->stages(), 0, bytes, data);
}

VkRenderingAttachmentInfo CommandList::attachment(const ColorTarget& target) {
  GpuImage& image = *target.image;
  assert(target.clear || image.state_.layout != VK_IMAGE_LAYOUT_UNDEFINED);
  const AccessScope scope = scopeOf(Access::ColorWrite);
  order(image, scope);
  VkRenderingAttachmentInfo info{};
  info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
  info.imageView = image.layerView(target.layer);
  info.imageLayout = scope.layout;
  info.loadOp = target.clear ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
  info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  std::copy(std::begin(target.clearValue), std::end(target.clearValue),
            std::begin(info.clearValue.color.float32));
  return info;
}

VkRenderingAttachmentInfo CommandList::attachment(const DepthTarget& target) {
  GpuImage& image = *target.image;
  assert(target.clear || image.state_.layout != VK_IMAGE_LAYOUT_UNDEFINED);
  assert(target.write || !target.clear);
  const AccessScope scope = scopeOf(target.write ? Access::DepthWrite : Access::DepthTest);
  order(image, scope);
  VkRenderingAttachmentInfo info{};
  info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
  info.imageView = image.layerView(target.layer);
  info.imageLayout = scope.layout;
  info.loadOp = target.clear ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
  info.storeOp = target.write ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_NONE;
  info.clearValue.depthStencil.depth = target.clearValue;
  return info;
}

void CommandList::beginRendering(std::span<const ColorTarget> colors, const DepthTarget* depth) {
  assert(recording_ && !rendering_);
  assert(colors.size() <= maxColors && (!colors.empty() || depth != nullptr));
  const VkExtent2D extent = colors.empty() ? depth->image->extent() : colors[0].image->extent();
  std::array<VkRenderingAttachmentInfo, maxColors> colorInfos;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    assert(colors[i].image->extent().width == extent.width &&
           colors[i].image->extent().height == extent.height);
    colorInfos[i] = attachment(colors[i]);
  }
  VkRenderingAttachmentInfo depthInfo{};
  if (depth != nullptr) {
    assert(depth->image->extent().width == extent.width &&
           depth->image->extent().height == extent.height);
    depthInfo = attachment(*depth);
  }
  flushBarriers();

  VkRenderingInfo info{};
  info.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
  info.renderArea.extent = extent;
  info.layerCount = 1;
  info.colorAttachmentCount = static_cast<std::uint32_t>(colors.size());
  info.pColorAttachments = colorInfos.data();
  info.pDepthAttachment = depth != nullptr ? &depthInfo : nullptr;
  vkCmdBeginRendering(commands_, &info);
  rendering_ = true;
  coverWith(extent);
}

void CommandList::coverWith(VkExtent2D extent) {
  const VkViewport viewport{
      0.0F, 0.0F, static_cast<float>(extent.width), static_cast<float>(extent.height), 0.0F, 1.0F};
  const VkRect2D scissor{{0, 0}, extent};
  vkCmdSetViewport(commands_, 0, 1, &viewport);
  vkCmdSetScissor(commands_, 0, 1, &scissor);
}

void CommandList::endRendering() {
  assert(recording_ && rendering_);
  vkCmdEndRendering(commands_);
  rendering_ = false;
}

}  // namespace opaline::gpu
