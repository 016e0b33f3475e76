#include "gpu/transfer.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cstring>

#include "gpu/device.h"
#include "opaline/error.h"

namespace opaline::gpu {

namespace {

template <typename Record>
void submit(Device& device, const char* name, Record record) {
  CommandList list(device, name, 0);
  list.begin();
  record(list);
  list.submit();
}

Buffer stage(Device& device, const std::string& name, std::span<const std::byte> data) {
  Buffer staging(device, {name + " (staging)", data.size(), 0, Memory::Upload});
  std::memcpy(staging.mapped().data(), data.data(), data.size());
  return staging;
}

std::size_t levelBytes(const GpuImage& image, std::uint32_t level) {
  const ImageOptions& options = image.options();
  assert(level < options.mipLevels);
  return std::size_t{std::max(1U, options.width >> level)} * std::max(1U, options.height >> level) *
         bytesPerTexel(options.format);
}

std::size_t roundUp(std::size_t bytes, std::size_t alignment) {
  return (bytes + alignment - 1) / alignment * alignment;
}

}  // namespace

Buffer makeBuffer(Device& device, const std::string& name, std::span<const std::byte> data,
                  VkBufferUsageFlags usage) {
  constexpr std::array<std::byte, 16> zeros{};
  if (data.empty()) data = zeros;
  Buffer buffer(device, {name, data.size(), usage, Memory::Device});
  Buffer staging = stage(device, name, data);
  submit(device, "upload",
         [&](CommandList& list) { list.copyBuffer(staging, buffer, data.size()); });
  return buffer;
}

void uploadImage(Device& device, GpuImage& image, std::span<const std::byte> texels,
                 std::uint32_t layer, std::uint32_t level) {
  assert(!texels.empty() && texels.size() == levelBytes(image, level));
  Buffer staging = stage(device, image.options().name, texels);
  submit(device, "upload",
         [&](CommandList& list) { list.copyToImage(staging, image, layer, level); });
}

std::vector<std::byte> readImage(Device& device, GpuImage& image,
                                 [[maybe_unused]] std::size_t texelBytes, std::uint32_t layer,
                                 std::uint32_t level) {
  assert(texelBytes > 0 && texelBytes == bytesPerTexel(image.options().format));
  Buffer staging(device, {image.options().name + " (readback)", levelBytes(image, level), 0,
                          Memory::Readback});
  submit(device, "readback", [&](CommandList& list) {
    list.copyFromImage(image, staging, layer, level);
    list.use(staging, Access::HostRead);
  });
  device.waitFor(device.submitted());
  return {staging.mapped().begin(), staging.mapped().end()};
}

std::vector<std::byte> readBuffer(Device& device, Buffer& buffer) {
  Buffer staging(device, {"readback", buffer.bytes(), 0, Memory::Readback});
  submit(device, "readback", [&](CommandList& list) {
    list.copyBuffer(buffer, staging, buffer.bytes());
    list.use(staging, Access::HostRead);
  });
  device.waitFor(device.submitted());
  return {staging.mapped().begin(), staging.mapped().end()};
}

UploadRing::UploadRing(Device& device, const std::string& name, std::size_t bytesPerFrame,
                       std::uint32_t frames, VkBufferUsageFlags usage)
    : device_(device),
      name_(name),
      alignment_(std::max<std::size_t>({16, device.limits().minUniformBufferOffsetAlignment,
                                        device.limits().minStorageBufferOffsetAlignment})),
      sliceBytes_(roundUp(bytesPerFrame, alignment_)),
      submissions_(frames) {
  assert(frames > 0 && bytesPerFrame > 0);
  buffer_ = Buffer(device, {name, sliceBytes_ * frames, usage, Memory::Upload});
}

void UploadRing::nextFrame() {
  slice_ = (slice_ + 1) % submissions_.size();
  // An abandoned frame was never submitted.
  device_.waitFor(std::min(submissions_[slice_], device_.submitted()));
  submissions_[slice_] = device_.submitted() + 1;
  used_ = 0;
}

std::size_t UploadRing::push(std::span<const std::byte> data) {
  if (data.size() > sliceBytes_ - used_) {
    throw Error(
        fmt::format("the upload buffer \"{}\" holds {} bytes a frame, of which {} are taken: {} "
                    "more do not fit",
                    name_, sliceBytes_, used_, data.size()));
  }
  const std::size_t offset = slice_ * sliceBytes_ + used_;
  std::memcpy(buffer_.mapped().data() + offset, data.data(), data.size());
  used_ = std::min(sliceBytes_, roundUp(used_ + data.size(), alignment_));
  return offset;
}

}  // namespace opaline::gpu
