#include <algorithm>
#include <cassert>

#include "gpu/command_list.h"

namespace opaline::gpu {

namespace {

VkBufferImageCopy regionOf(const GpuImage& image, std::uint32_t layer, std::uint32_t level,
                           [[maybe_unused]] const Buffer& buffer, std::size_t offset) {
  const ImageOptions& options = image.options();
  assert(layer < options.layers && level < options.mipLevels);
  VkBufferImageCopy region{};
  region.bufferOffset = offset;
  region.imageSubresource = {image.aspect(), level, layer, 1};
  region.imageExtent = {std::max(1U, options.width >> level), std::max(1U, options.height >> level),
                        1};
  assert(offset + std::size_t{region.imageExtent.width} * region.imageExtent.height *
                      bytesPerTexel(options.format) <=
         buffer.bytes());
  return region;
}

}  // namespace

void CommandList::copyBuffer(Buffer& from, Buffer& to, std::size_t bytes, std::size_t fromOffset,
                             std::size_t toOffset) {
  assert(recording_ && &from != &to);
  assert(fromOffset + bytes <= from.bytes() && toOffset + bytes <= to.bytes());
  order(from, scopeOf(Access::TransferRead));
  order(to, scopeOf(Access::TransferWrite));
  flushBarriers();
  const VkBufferCopy region{fromOffset, toOffset, bytes};
  vkCmdCopyBuffer(commands_, from.handle(), to.handle(), 1, &region);
}

void CommandList::copyToImage(Buffer& from, GpuImage& to, std::uint32_t layer, std::uint32_t level,
                              std::size_t fromOffset) {
  assert(recording_);
  order(from, scopeOf(Access::TransferRead));
  order(to, scopeOf(Access::TransferWrite));
  flushBarriers();
  const VkBufferImageCopy region = regionOf(to, layer, level, from, fromOffset);
  vkCmdCopyBufferToImage(commands_, from.handle(), to.handle(), to.state_.layout, 1, &region);
}

void CommandList::copyFromImage(GpuImage& from, Buffer& to, std::uint32_t layer,
                                std::uint32_t level, std::size_t toOffset) {
  assert(recording_);
  assert(from.state_.layout != VK_IMAGE_LAYOUT_UNDEFINED);
  order(from, scopeOf(Access::TransferRead));
  order(to, scopeOf(Access::TransferWrite));
  flushBarriers();
  const VkBufferImageCopy region = regionOf(from, layer, level, to, toOffset);
  vkCmdCopyImageToBuffer(commands_, from.handle(), from.state_.layout, to.handle(), 1, &region);
}

void CommandList::fill(Buffer& buffer, std::uint32_t value) {
  assert(recording_ && buffer.bytes() % 4 == 0);
  order(buffer, scopeOf(Access::TransferWrite));
  flushBarriers();
  vkCmdFillBuffer(commands_, buffer.handle(), 0, VK_WHOLE_SIZE, value);
}

void CommandList::clear(GpuImage& image) {
  assert(recording_ && !rendering_ && image.aspect() == VK_IMAGE_ASPECT_COLOR_BIT);
  order(image, scopeOf(Access::TransferWrite));
  flushBarriers();
  const VkClearColorValue nothing{};
  const VkImageSubresourceRange whole{VK_IMAGE_ASPECT_COLOR_BIT, 0, VK_REMAINING_MIP_LEVELS, 0,
                                      VK_REMAINING_ARRAY_LAYERS};
  vkCmdClearColorImage(commands_, image.handle(), image.state_.layout, &nothing, 1, &whole);
}

}  // namespace opaline::gpu
