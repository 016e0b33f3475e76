#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/command_list.h"
#include "gpu/image.h"

namespace opaline::gpu {

class Device;

/// Makes a device buffer with a copy of `data`, for work that is submitted from now on. For set-up,
/// not for frames. Empty data gives 16 zero bytes, so that the buffer can always be bound.
Buffer makeBuffer(Device& device, const std::string& name, std::span<const std::byte> data,
                  VkBufferUsageFlags usage);
template <typename T>
Buffer makeBuffer(Device& device, const std::string& name, const std::vector<T>& data,
                  VkBufferUsageFlags usage) {
  return makeBuffer(device, name, std::as_bytes(std::span<const T>(data)), usage);
}

/// Fills one layer and level of an image, for work that is submitted from now on. For set-up, not
/// for frames.
void uploadImage(Device& device, GpuImage& image, std::span<const std::byte> texels,
                 std::uint32_t layer = 0, std::uint32_t level = 0);

/// Copies texels to the host; blocks. `bytesPerTexel` must fit the image's format.
std::vector<std::byte> readImage(Device& device, GpuImage& image, std::size_t bytesPerTexel,
                                 std::uint32_t layer = 0, std::uint32_t level = 0);
std::vector<std::byte> readBuffer(Device& device, Buffer& buffer);

/// Host-visible memory for data that changes every frame, with one slice per frame in flight. It
/// allocates nothing after construction.
class UploadRing {
 public:
  UploadRing(Device& device, const std::string& name, std::size_t bytesPerFrame,
             std::uint32_t frames, VkBufferUsageFlags usage);

  /// Starts the next slice, for work that is submitted next. Waits until the device no longer reads
  /// the slice's old data.
  void nextFrame();
  /// Copies `data` into the slice; returns its offset in buffer(), aligned for uniform and storage
  /// bindings. Throws Error when the slice is full.
  std::size_t push(std::span<const std::byte> data);
  template <typename T>
  std::size_t push(const T& value) {
    return push(std::as_bytes(std::span<const T>(&value, 1)));
  }
  Buffer& buffer() { return buffer_; }

 private:
  Device& device_;
  std::string name_;
  Buffer buffer_;
  std::size_t alignment_ = 256;
  std::size_t sliceBytes_ = 0;
  std::vector<std::uint64_t> submissions_;  // the last that reads each slice
  std::size_t slice_ = 0;
  std::size_t used_ = 0;
};

}  // namespace opaline::gpu
