#include "gpu/command_list.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>

#include "gpu/acceleration_structure.h"
#include "gpu/device.h"
#include "gpu/vulkan_result.h"

namespace opaline::gpu {

namespace {

VkDeviceSize rangeOf(const Binding& binding, const VkPhysicalDeviceLimits& limits) {
  assert(binding.offset < binding.buffer->bytes());
  const std::size_t rest = binding.buffer->bytes() - binding.offset;
  assert(binding.bytes <= rest);
  if (binding.bytes != 0) return binding.bytes;
  if (binding.type != BindingType::UniformBuffer) return rest;
  return std::min<VkDeviceSize>(rest, limits.maxUniformBufferRange);
}

bool sameResource(const Binding& a, const Binding& b) {
  return a.buffer == b.buffer && a.image == b.image;
}

AccessScope bindingScope(const Binding& binding) {
  AccessScope scope = scopeOf(binding.access);
  if (binding.buffer != nullptr) scope.layout = VK_IMAGE_LAYOUT_UNDEFINED;
  return scope;
}

tape::Resource resourceOf(const Binding& binding, const VkPhysicalDeviceLimits& limits) {
  tape::Resource resource{.slot = binding.slot, .type = descriptorTypeOf(binding.type)};
  if (binding.type == BindingType::TexelBuffer) {
    resource.texels = binding.buffer->texelView();
  } else if (binding.type == BindingType::AccelerationStructure) {
    resource.structure = binding.structure;
  } else if (binding.buffer != nullptr) {
    resource.buffer = binding.buffer->handle();
    resource.offset = binding.offset;
    resource.range = rangeOf(binding, limits);
  } else {
    resource.sampler = binding.sampler;
    resource.view = binding.view;
    resource.imageLayout = bindingScope(binding).layout;
  }
  return resource;
}

std::array<std::uint32_t, 4> bitsOf(const float (&values)[4]) {
  return std::bit_cast<std::array<std::uint32_t, 4>>(values);
}

}  // namespace

CommandList::CommandList(Device& device, std::string name, std::uint32_t maxPasses)
    : device_(device), name_(std::move(name)), timer_(device, name_, maxPasses) {
  VkCommandPoolCreateInfo poolInfo{};
  poolInfo.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  poolInfo.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  poolInfo.queueFamilyIndex = device.queueFamily();
  VkResult result = device.vk().vkCreateCommandPool(device.handle(), &poolInfo, nullptr, &pool_);
  std::array<VkCommandBuffer, maxParts> buffers{};
  if (result >= 0) result = allocate(VK_COMMAND_BUFFER_LEVEL_PRIMARY, buffers);
  if (result < 0) {
    device.vk().vkDestroyCommandPool(device.handle(), pool_, nullptr);
    check(result, fmt::format("create the command list \"{}\"", name_));
  }
  device.setName(VK_OBJECT_TYPE_COMMAND_POOL, reinterpret_cast<std::uint64_t>(pool_), name_);
  for (std::size_t i = 0; i < maxParts; ++i) parts_[i].submitted.buffer = buffers[i];
}

VkResult CommandList::allocate(VkCommandBufferLevel level, std::span<VkCommandBuffer> buffers) {
  VkCommandBufferAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
  info.commandPool = pool_;
  info.level = level;
  info.commandBufferCount = static_cast<std::uint32_t>(buffers.size());
  const VkResult result =
      device_.vk().vkAllocateCommandBuffers(device_.handle(), &info, buffers.data());
  if (result < 0) return result;
  for (const VkCommandBuffer buffer : buffers)
    device_.setName(VK_OBJECT_TYPE_COMMAND_BUFFER, reinterpret_cast<std::uint64_t>(buffer), name_);
  return result;
}

CommandList::~CommandList() {
  device_.retire(VK_OBJECT_TYPE_COMMAND_POOL, pool_);
}

void CommandList::begin() {
  wait();
  filling_ = true;
  counts_ = {};
  inPass_ = false;
  rendering_ = false;
  part_ = 0;
  imageBarrierCount_ = 0;
  memoryBarrier_ = {};
  beginPart();
  timer_.reset();
  if (!device_.takeAbandoned()) return;
  constexpr VkAccessFlags2 all = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  memoryBarrier_ = {.fromStages = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                    .fromAccesses = VK_ACCESS_2_MEMORY_WRITE_BIT,
                    .toStages = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                    .toAccesses = all};
  flushBarriers();
}

void CommandList::abandon() {
  filling_ = false;
  device_.noteAbandoned();
}

void CommandList::beginPart() {
  parts_[part_].wanted.clear();
  parts_[part_].borrows = false;
  pipeline_ = nullptr;
  for (auto& slots : bound_) slots.fill({});
}

void CommandList::cut() {
  assert(filling_ && !inPass_ && !rendering_ && part_ + 1 < maxParts);
  flushBarriers();
  ++part_;
  beginPart();
}

void CommandList::finishFilling() {
  assert(filling_ && !inPass_ && !rendering_);
  flushBarriers();
  filling_ = false;
}

void CommandList::submit(std::span<const SemaphoreValue> waits,
                         std::span<const SemaphoreValue> signals) {
  finishFilling();
  std::array<VkCommandBuffer, maxParts> buffers{};
  for (std::size_t i = 0; i <= part_; ++i) {
    Recording& recording = parts_[i].submitted;
    if (!isRecorded(recording, parts_[i])) record(parts_[i], recording, 0);
    buffers[i] = recording.buffer;
  }
  submission_ = device_.submit(std::span(buffers).first(part_ + 1), waits, signals);
}

// Equal handles mean the same objects only if no object has been destroyed since.
bool CommandList::isRecorded(const Recording& recording, const Part& part) const {
  return recording.keeps && recording.retired == device_.retired() &&
         recording.recorded == part.wanted;
}

void CommandList::record(const Part& part, Recording& recording, VkCommandBufferUsageFlags usage) {
  recording.keeps = false;
  VkCommandBufferInheritanceInfo inherited{};
  inherited.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_INHERITANCE_INFO;
  VkCommandBufferBeginInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  info.flags = usage;
  info.pInheritanceInfo = &inherited;  // only for secondary command buffers
  check(device_.vk().vkBeginCommandBuffer(recording.buffer, &info), "begin a command list");
  part.wanted.record(device_, recording.buffer);
  // The message is made only on failure, since frames must not allocate.
  const VkResult recorded = device_.vk().vkEndCommandBuffer(recording.buffer);
  if (recorded < 0) check(recorded, fmt::format("record \"{}\"", name_));
  recording.recorded = part.wanted;
  recording.retired = device_.retired();
  recording.keeps = !part.borrows;
  ++counts_.recordings;
}

void CommandList::recordInto(VkCommandBuffer commands, const SemaphoreValue& done) {
  finishFilling();
  for (std::size_t i = 0; i <= part_; ++i) executeIn(commands, parts_[i]);
  submission_ = device_.expect(done);
}

// Commands that come a second time are kept from then on; others are recorded for one submission.
void CommandList::executeIn(VkCommandBuffer commands, Part& part) {
  Recording& recording = part.executed;
  if (!isRecorded(recording, part)) {
    recording.keeps = false;
    const bool again = !part.borrows && recording.recorded == part.wanted;
    if (!again) {
      part.wanted.record(device_, commands);
      recording.recorded = part.wanted;
      ++counts_.recordings;
      return;
    }
    if (recording.buffer == VK_NULL_HANDLE)
      check(allocate(VK_COMMAND_BUFFER_LEVEL_SECONDARY, {&recording.buffer, 1}),
            "extend a command list");
    record(part, recording, 0);
  }
  device_.vk().vkCmdExecuteCommands(commands, 1, &recording.buffer);
}

void CommandList::wait() {
  if (submission_ == 0) return;
  device_.waitFor(submission_);
  submission_ = 0;
  timer_.collect();
}

void CommandList::beginPass(const char* name) {
  assert(filling_ && !inPass_ && !rendering_);
  timer_.begin(commands(), name);
  commands().add(tape::BeginLabel{name});
  inPass_ = true;
}

void CommandList::endPass() {
  assert(filling_ && inPass_);
  commands().add(tape::EndLabel{});
  timer_.end(commands());
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
  if (buffer.isBorrowed()) parts_[part_].borrows = true;
  CommandOrder& commands = device_.commandOrder();
  const std::uint64_t last = buffer.state_.command;
  const auto barrier = advance(buffer.state_, scope);
  buffer.state_.command = commands.next();
  if (!barrier || commands.hasOrdered(*barrier, last)) return;
  memoryBarrier_.fromStages |= barrier->fromStages;
  memoryBarrier_.fromAccesses |= barrier->fromAccesses;
  memoryBarrier_.toStages |= barrier->toStages;
  memoryBarrier_.toAccesses |= barrier->toAccesses;
}

void CommandList::order(GpuImage& image, const AccessScope& scope) {
  add(image, advance(image.state_, scope));
}

void CommandList::prepare(GpuImage& image, Access write) {
  add(image, gpu::prepare(image.state_, scopeOf(write)));
}

void CommandList::add(GpuImage& image, const std::optional<AccessBarrier>& barrier) {
  if (image.isBorrowed()) parts_[part_].borrows = true;
  if (!barrier) return;
  assert(imageBarrierCount_ < imageBarriers_.size());
  imageBarriers_[imageBarrierCount_++] = {image.handle(), image.aspect(), *barrier};
}

// Called before each command.
void CommandList::flushBarriers() {
  CommandOrder& order = device_.commandOrder();
  if (memoryBarrier_.toStages != 0 || imageBarrierCount_ != 0) {
    widen(memoryBarrier_);
    // Resources that were bound for an earlier command may be read and written by this one.
    if (boundFor_ == order.next()) order.note(memoryBarrier_);
    addBarrier();
  }
  order.noteCommand();
}

void CommandList::addBarrier() {
  assert(filling_);
  assert(!rendering_ && "a barrier inside a rendering scope: bind before beginRendering");
  ++counts_.barriers;
  commands().add(memoryBarrier_, std::span(imageBarriers_).first(imageBarrierCount_));
  memoryBarrier_ = {};
  imageBarrierCount_ = 0;
}

void CommandList::use(Buffer& buffer, Access access) {
  order(buffer, scopeOf(access));
  // No ordering is left after that: the host waits for everything.
  if (access == Access::HostRead) buffer.state_ = {};
}

void CommandList::use(GpuImage& image, Access access) {
  order(image, scopeOf(access));
}

void CommandList::bindPipeline(const Pipeline& pipeline) {
  assert(filling_ && pipeline);
  if (pipeline_ == &pipeline) return;
  pipeline_ = &pipeline;
  commands().add(tape::BindPipeline{pipeline.bindPoint(), pipeline.handle()});
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
  if (rendering_) flushBarriers();  // inside rendering there must be no barriers
}

void CommandList::bindResources(std::span<const Binding> given) {
  assert(filling_ && pipeline_ != nullptr && given.size() <= maxSlots);
  if (given.empty()) return;
  std::array<Binding, maxSlots> asWanted;
  std::transform(given.begin(), given.end(), asWanted.begin(), [&](const Binding& binding) {
    return pipeline_->isStorage(binding.slot) ? binding.asStorage() : binding;
  });
  const std::span<const Binding> bindings(asWanted.data(), given.size());
  orderBindings(bindings);
  boundFor_ = device_.commandOrder().next();
  std::array<tape::Resource, maxSlots> resources;
  for (std::size_t i = 0; i < bindings.size(); ++i) {
    assert(pipeline_->hasSlot(bindings[i].slot));
    resources[i] = resourceOf(bindings[i], device_.limits());
    bound_[pipeline_->bindPoint()][bindings[i].slot] = bindings[i];
  }
  commands().add(pipeline_->bindPoint(), pipeline_->layout(),
                 std::span(std::as_const(resources)).first(bindings.size()));
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
  assert(filling_ && !rendering_);
  order(corners, scopeOf(Access::RayInput));
  order(structure.storage_, scopeOf(Access::RayBuild));
  order(structure.scratch_, scopeOf(Access::RayBuild));
  flushBarriers();
  using Built = tape::BuildStructure::Part;
  commands().add(tape::BuildStructure{&structure, structure.handle(),
                                      refit ? Built::RefitTriangles : Built::Triangles});
  order(structure.storage_, scopeOf(Access::RayBuild));
  flushBarriers();
  commands().add(tape::BuildStructure{&structure, structure.handle(), Built::Bodies});
}

void CommandList::pushBytes(const void* data, std::uint32_t bytes) {
  assert(bytes == pipeline_->pushConstantBytes());
  commands().add(pipeline_->layout(), pipeline_->stages(),
                 std::span(static_cast<const std::byte*>(data), bytes));
}

// Borrowed images keep the layout that their owner gave them.
AccessScope CommandList::scopeOfTarget(const GpuImage& image, Access access) {
  AccessScope scope = scopeOf(access);
  if (image.isBorrowed()) scope.layout = image.state_.layout;
  return scope;
}

// Drawing to one layer after the other needs no barrier in between.
void CommandList::orderTarget(GpuImage& image, std::uint32_t layer, const AccessScope& scope) {
  const AccessState& state = image.state_;
  const bool drawnLast = state.layout == scope.layout && state.writeStages == scope.stages &&
                         state.writeAccesses == scope.accesses && state.readStages == 0;
  if (!scope.writes || !drawnLast || layer < image.attachedLayers_) order(image, scope);
  image.attachedLayers_ = layer + 1;
}

tape::Target CommandList::attachment(const ColorTarget& target) {
  GpuImage& image = *target.image;
  assert(target.clear || image.state_.layout != VK_IMAGE_LAYOUT_UNDEFINED);
  const AccessScope scope = scopeOfTarget(image, Access::ColorWrite);
  orderTarget(image, target.layer, scope);
  return {image.layerView(target.layer), scope.layout, target.clear, true,
          bitsOf(target.clearValue)};
}

tape::Target CommandList::attachment(const DepthTarget& target) {
  GpuImage& image = *target.image;
  assert(target.clear || image.state_.layout != VK_IMAGE_LAYOUT_UNDEFINED);
  assert(target.write || !target.clear);
  const AccessScope scope =
      scopeOfTarget(image, target.write ? Access::DepthWrite : Access::DepthTest);
  orderTarget(image, target.layer, scope);
  return {image.layerView(target.layer), scope.layout, target.clear, target.write,
          bitsOf({target.clearValue, 0, 0, 0})};
}

void CommandList::beginRendering(std::span<const ColorTarget> colors, const DepthTarget* depth) {
  assert(filling_ && !rendering_);
  assert(colors.size() <= maxColors && (!colors.empty() || depth != nullptr));
  const VkExtent2D extent = colors.empty() ? depth->image->extent() : colors[0].image->extent();
  [[maybe_unused]] const auto covers = [extent](const GpuImage& image) {
    return image.extent().width == extent.width && image.extent().height == extent.height;
  };
  std::array<tape::Target, maxColors + 1> targets;
  std::size_t count = 0;
  for (const ColorTarget& color : colors) {
    assert(covers(*color.image));
    targets[count++] = attachment(color);
  }
  if (depth != nullptr) {
    assert(covers(*depth->image));
    targets[count++] = attachment(*depth);
  }
  flushBarriers();
  commands().add(
      {extent.width, extent.height, static_cast<std::uint32_t>(colors.size()), depth != nullptr},
      std::span(std::as_const(targets)).first(count));
  rendering_ = true;
}

void CommandList::endRendering() {
  assert(filling_ && rendering_);
  commands().add(tape::EndRendering{});
  rendering_ = false;
}

}  // namespace opaline::gpu
