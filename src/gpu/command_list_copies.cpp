#include <algorithm>
#include <cassert>

#include "gpu/command_list.h"

namespace opaline::gpu {

namespace {

tape::CopyImage copyOf(const GpuImage& image, std::uint32_t layer, std::uint32_t level,
                       const Buffer& buffer, std::size_t offset) {
  const ImageOptions& options = image.options();
  assert(layer < options.layers && level < options.mipLevels);
  const tape::CopyImage copy{.image = image.handle(),
                             .aspect = image.aspect(),
                             .width = std::max(1U, options.width >> level),
                             .height = std::max(1U, options.height >> level),
                             .layer = layer,
                             .level = level,
                             .buffer = buffer.handle(),
                             .offset = offset};
  assert(offset + std::size_t{copy.width} * copy.height * bytesPerTexel(options.format) <=
         buffer.bytes());
  return copy;
}

}  // namespace

void CommandList::copyBuffer(Buffer& from, Buffer& to, std::size_t bytes, std::size_t fromOffset,
                             std::size_t toOffset) {
  const BufferCopy copy{&from, &to, bytes, fromOffset, toOffset};
  copyBuffers({&copy, 1});
}

void CommandList::copyBuffers(std::span<const BufferCopy> copies) {
  assert(filling_);
  for (const BufferCopy& copy : copies) {
    if (copy.bytes == 0) continue;
    assert(copy.from != copy.to);
    assert(copy.fromOffset + copy.bytes <= copy.from->bytes());
    assert(copy.toOffset + copy.bytes <= copy.to->bytes());
    order(*copy.from, scopeOf(Access::TransferRead));
    order(*copy.to, scopeOf(Access::TransferWrite));
  }
  flushBarriers();
  for (const BufferCopy& copy : copies)
    if (copy.bytes > 0)
      commands().add(tape::CopyBuffer{copy.from->handle(), copy.to->handle(), copy.fromOffset,
                                      copy.toOffset, copy.bytes});
}

void CommandList::copyToImage(Buffer& from, GpuImage& to, std::uint32_t layer, std::uint32_t level,
                              std::size_t fromOffset) {
  assert(filling_);
  order(from, scopeOf(Access::TransferRead));
  order(to, scopeOf(Access::TransferWrite));
  flushBarriers();
  tape::CopyImage copy = copyOf(to, layer, level, from, fromOffset);
  copy.toImage = true;
  copy.layout = to.state_.layout;
  commands().add(copy);
}

void CommandList::copyFromImage(GpuImage& from, Buffer& to, std::uint32_t layer,
                                std::uint32_t level, std::size_t toOffset) {
  assert(filling_);
  assert(from.state_.layout != VK_IMAGE_LAYOUT_UNDEFINED);
  order(from, scopeOf(Access::TransferRead));
  order(to, scopeOf(Access::TransferWrite));
  flushBarriers();
  tape::CopyImage copy = copyOf(from, layer, level, to, toOffset);
  copy.layout = from.state_.layout;
  commands().add(copy);
}

void CommandList::fill(std::initializer_list<std::reference_wrapper<Buffer>> buffers,
                       std::uint32_t value) {
  assert(filling_);
  for (Buffer& buffer : buffers) order(buffer, scopeOf(Access::TransferWrite));
  flushBarriers();
  for (const Buffer& buffer : buffers) {
    assert(buffer.bytes() % 4 == 0);
    commands().add(tape::FillBuffer{buffer.handle(), value});
  }
}

void CommandList::clear(GpuImage& image) {
  assert(filling_ && !rendering_ && image.aspect() == VK_IMAGE_ASPECT_COLOR_BIT);
  order(image, scopeOf(Access::TransferWrite));
  flushBarriers();
  commands().add(tape::ClearImage{image.handle(), image.state_.layout});
}

}  // namespace opaline::gpu
