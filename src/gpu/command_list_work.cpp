#include <algorithm>
#include <cassert>
#include <cstdint>

#include "gpu/command_list.h"

namespace opaline::gpu {

void CommandList::dispatch(std::uint32_t groupsX, std::uint32_t groupsY, std::uint32_t groupsZ) {
  assert(filling_ && !rendering_ && pipeline_ != nullptr);
  assert(pipeline_->bindPoint() == VK_PIPELINE_BIND_POINT_COMPUTE);
  assert(boundIsCurrent());
  flushBarriers();
  ++counts_.dispatches;
  commands().add(tape::Dispatch{0, groupsX, groupsY, groupsZ});
}

// The most rounds of one dispatch or draw. Drivers reset a device with a display when one command
// takes some 2 s; a slow integrated device does 3e9 rounds per second.
constexpr std::uint64_t mostRounds = std::uint64_t{1} << 31U;

constexpr std::uint32_t sizeOfGroup = 64;

void CommandList::dispatchRows(std::uint32_t groupsX, std::uint32_t groupsY, std::uint32_t rounds) {
  const std::uint64_t ofRow = std::uint64_t{sizeOfGroup} * groupsX * rounds;
  const auto rows = static_cast<std::uint32_t>(std::clamp<std::uint64_t>(
      mostRounds / std::max<std::uint64_t>(ofRow, 1), 1, std::max(groupsY, 1U)));
  assert(filling_ && !rendering_ && pipeline_ != nullptr);
  assert(pipeline_->bindPoint() == VK_PIPELINE_BIND_POINT_COMPUTE);
  assert(boundIsCurrent());
  flushBarriers();
  for (std::uint32_t row = 0; row < groupsY; row += rows) {
    ++counts_.dispatches;
    commands().add(tape::Dispatch{row, groupsX, std::min(rows, groupsY - row), 1});
  }
}

void CommandList::dispatchLinear(std::uint32_t count, std::uint32_t rounds) {
  dispatchGroups((count + sizeOfGroup - 1) / sizeOfGroup, rounds);
}

// The lanes of a thing share its rounds of work.
void CommandList::dispatchLanes(std::uint32_t count, std::uint32_t rounds) {
  const std::uint32_t lanes = device_.workGroups().lanes;
  const std::uint32_t things = sizeOfGroup / lanes;
  dispatchGroups((count + things - 1) / things, (rounds - 1) / lanes + 1);
}

void CommandList::dispatchGroups(std::uint32_t groups, std::uint32_t rounds) {
  constexpr std::uint32_t most = 32768;  // every device dispatches that many along an axis
  if (groups == 0) return;
  const std::uint64_t atOnce = mostRounds / (std::uint64_t{sizeOfGroup} * rounds);
  const auto row = static_cast<std::uint32_t>(
      std::clamp<std::uint64_t>(atOnce, (groups + most - 1) / most, most));
  const std::uint32_t rows = (groups + row - 1) / row;
  dispatchRows((groups + rows - 1) / rows, rows, rounds);
}

void CommandList::dispatchTiles(const GpuImage& image, std::uint32_t rounds) {
  constexpr std::uint32_t tileSize = 8;
  const VkExtent2D extent = image.extent();
  dispatchRows((extent.width + tileSize - 1) / tileSize, (extent.height + tileSize - 1) / tileSize,
               rounds);
}

void CommandList::dispatchIndirect(Buffer& groups, std::size_t offset) {
  assert(filling_ && !rendering_ && pipeline_ != nullptr);
  assert(pipeline_->bindPoint() == VK_PIPELINE_BIND_POINT_COMPUTE);
  assert(boundIsCurrent());
  assert(((groups.state_.readAccesses | groups.state_.writeAccesses) &
          VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT) != 0);
  assert(offset + sizeof(VkDispatchIndirectCommand) <= groups.bytes());
  flushBarriers();
  ++counts_.dispatches;
  commands().add(tape::DispatchIndirect{groups.handle(), offset});
}

void CommandList::draw(std::uint32_t vertices, std::uint32_t firstVertex) {
  assert(filling_ && rendering_ && pipeline_ != nullptr);
  assert(pipeline_->bindPoint() == VK_PIPELINE_BIND_POINT_GRAPHICS);
  assert(boundIsCurrent());
  commands().add(tape::Draw{vertices, firstVertex});
}

void CommandList::drawIndexed(Buffer& indices, std::uint32_t count, std::uint32_t firstIndex) {
  assert(filling_ && rendering_ && pipeline_ != nullptr);
  assert(pipeline_->bindPoint() == VK_PIPELINE_BIND_POINT_GRAPHICS);
  assert(boundIsCurrent());
  assert((firstIndex + count) * sizeof(std::uint32_t) <= indices.bytes());
  commands().add(tape::DrawIndexed{indices.handle(), count, firstIndex});
}

}  // namespace opaline::gpu
