#include "gpu/access.h"

#include <cassert>
#include <utility>

namespace opaline::gpu {

namespace {

constexpr VkPipelineStageFlags2 shaderStages = VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT |
                                               VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT |
                                               VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
constexpr VkPipelineStageFlags2 depthStages =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;

constexpr VkAccessFlags2 storageAccesses =
    VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
// Accesses of shaders to buffers, as storage or as texels.
constexpr VkAccessFlags2 bufferAccesses =
    storageAccesses | VK_ACCESS_2_SHADER_SAMPLED_READ_BIT | VK_ACCESS_2_UNIFORM_READ_BIT;

bool covers(const AccessState& state, const AccessScope& scope) {
  return (scope.stages & ~state.readStages) == 0 && (scope.accesses & ~state.readAccesses) == 0;
}

void addRead(AccessState& state, const AccessScope& scope) {
  state.readStages |= scope.stages;
  state.readAccesses |= scope.accesses;
}

}  // namespace

// ATTACHMENT_OPTIMAL and READ_ONLY_OPTIMAL (Vulkan 1.3) mean the colour or the depth layout,
// whichever fits the image's format.
AccessScope scopeOf(Access access) {
  switch (access) {
    case Access::None:
      return {};
    case Access::ColorWrite:
      return {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
              VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
              VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL, true};
    case Access::DepthWrite:
      return {depthStages,
              VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT |
                  VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
              VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL, true};
    case Access::DepthTest:
      return {depthStages, VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT,
              VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL, false};
    case Access::Sampled:
      return {shaderStages, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT, VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL,
              false};
    case Access::StorageRead:
      return {shaderStages, VK_ACCESS_2_SHADER_STORAGE_READ_BIT, VK_IMAGE_LAYOUT_GENERAL, false};
    case Access::StorageWrite:
      return {shaderStages,
              VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
              VK_IMAGE_LAYOUT_GENERAL, true};
    case Access::Uniform:
      return {shaderStages, VK_ACCESS_2_UNIFORM_READ_BIT, VK_IMAGE_LAYOUT_UNDEFINED, false};
    case Access::Index:
      return {VK_PIPELINE_STAGE_2_INDEX_INPUT_BIT, VK_ACCESS_2_INDEX_READ_BIT,
              VK_IMAGE_LAYOUT_UNDEFINED, false};
    case Access::Indirect:
      return {VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT,
              VK_IMAGE_LAYOUT_UNDEFINED, false};
    case Access::StorageWriteIndirect:
      return {shaderStages | VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT,
              VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT |
                  VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT,
              VK_IMAGE_LAYOUT_GENERAL, true};
    case Access::Lent:
      return {shaderStages | VK_PIPELINE_STAGE_2_VERTEX_ATTRIBUTE_INPUT_BIT |
                  VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
              VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_VERTEX_ATTRIBUTE_READ_BIT |
                  VK_ACCESS_2_TRANSFER_READ_BIT,
              VK_IMAGE_LAYOUT_UNDEFINED, false};
    case Access::TransferRead:
      return {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
              VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, false};
    case Access::TransferWrite:
      return {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
              VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, true};
    case Access::RayBuild:
      return {VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR,
              VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR |
                  VK_ACCESS_2_ACCELERATION_STRUCTURE_WRITE_BIT_KHR,
              VK_IMAGE_LAYOUT_UNDEFINED, true};
    case Access::RayInput:
      return {VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR, VK_ACCESS_2_SHADER_READ_BIT,
              VK_IMAGE_LAYOUT_UNDEFINED, false};
    case Access::RayQuery:
      return {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
              VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR, VK_IMAGE_LAYOUT_UNDEFINED, false};
    case Access::HostRead:
      return {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT, VK_IMAGE_LAYOUT_GENERAL,
              false};
  }
  assert(false);
  return {};
}

AccessScope together(const AccessScope& a, const AccessScope& b) {
  assert(a.layout == b.layout && "one command uses an image in two layouts");
  return {a.stages | b.stages, a.accesses | b.accesses, a.layout, a.writes || b.writes};
}

std::optional<AccessBarrier> advance(AccessState& state, const AccessScope& next) {
  const bool wasPrepared = std::exchange(state.isPrepared, false);
  if (wasPrepared && next.writes && next.stages == state.writeStages &&
      next.accesses == state.writeAccesses && next.layout == state.layout)
    return std::nullopt;
  if (next.stages == 0) {  // Access::None: forgets the contents, but not who still uses them
    state.layout = VK_IMAGE_LAYOUT_UNDEFINED;
    return std::nullopt;
  }
  const bool layoutChanges = state.layout != next.layout;
  AccessBarrier barrier{state.writeStages, state.writeAccesses, next.stages,
                        next.accesses,     state.layout,        next.layout};
  if (next.writes || layoutChanges) {
    barrier.fromStages |= state.readStages;
    // A change of layout is itself a write; later reads chain to it through the stages that waited.
    state = {next.layout, next.stages, next.writes ? next.accesses : 0};
    if (!next.writes) addRead(state, next);
    if (layoutChanges || barrier.fromStages != 0) return barrier;
    return std::nullopt;
  }
  if (covers(state, next)) return std::nullopt;
  addRead(state, next);
  if (state.writeStages == 0) return std::nullopt;
  return barrier;
}

void widen(AccessBarrier& barrier) {
  if ((barrier.fromStages & shaderStages) == 0 || (barrier.toStages & shaderStages) == 0) return;
  barrier.fromStages |= shaderStages;
  barrier.fromAccesses |= storageAccesses;
  barrier.toStages |= shaderStages;
  barrier.toAccesses |= bufferAccesses;
}

void CommandOrder::note(const AccessBarrier& barrier) {
  const bool isWide = (shaderStages & ~(barrier.fromStages & barrier.toStages)) == 0 &&
                      (storageAccesses & ~barrier.fromAccesses) == 0 &&
                      (bufferAccesses & ~barrier.toAccesses) == 0;
  if (isWide) ordered_ = next_;
}

bool CommandOrder::hasOrdered(const AccessBarrier& barrier, std::uint64_t command) const {
  return command < ordered_ && ((barrier.fromStages | barrier.toStages) & ~shaderStages) == 0 &&
         ((barrier.fromAccesses | barrier.toAccesses) & ~bufferAccesses) == 0;
}

std::optional<AccessBarrier> prepare(AccessState& state, const AccessScope& next) {
  assert(next.writes);
  const std::optional<AccessBarrier> barrier = advance(state, next);
  state.isPrepared = true;
  return barrier;
}

}  // namespace opaline::gpu
