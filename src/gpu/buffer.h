#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <span>
#include <string>

#include "gpu/access.h"

namespace opaline::gpu {

class Device;

enum class Memory {
  Device,    ///< fast for the device, not visible to the host
  Upload,    ///< written by the host, permanently mapped
  Readback,  ///< read by the host, permanently mapped and cached where possible
};

struct BufferOptions {
  std::string name;
  std::size_t bytes = 0;         ///< > 0; at most the device's storage-buffer range if used as such
  VkBufferUsageFlags usage = 0;  ///< copies from and to it are always allowed; a texel buffer holds
                                 ///< texels of four floats
  Memory memory = Memory::Device;
  bool lent = false;  ///< the caller submits work to the queue that uses it
};

/// A buffer with memory of its own, unless it is borrowed. Movable.
class Buffer {
 public:
  Buffer() = default;
  /// A buffer of the caller's, who keeps it alive and makes its writes visible to later use.
  static Buffer borrowed(VkBuffer buffer, std::size_t bytes);
  Buffer(Device& device, const BufferOptions& options);
  ~Buffer();
  Buffer(Buffer&& other) noexcept;
  Buffer& operator=(Buffer&& other) noexcept;
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  explicit operator bool() const { return buffer_ != VK_NULL_HANDLE; }
  VkBuffer handle() const { return buffer_; }
  std::size_t bytes() const { return bytes_; }
  bool isBorrowed() const { return device_ == nullptr; }
  VkBufferView texelView() const { return texelView_; }  ///< of the whole buffer
  /// The address for shaders and builds. Needs VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT.
  VkDeviceAddress address() const;

  /// The mapped memory of an Upload or Readback buffer.
  std::span<std::byte> mapped() const { return {mapped_, bytes_}; }
  template <typename T>
  std::span<T> mappedAs() const {
    return {reinterpret_cast<T*>(mapped_), bytes_ / sizeof(T)};
  }

 private:
  friend class CommandList;
  void swap(Buffer& other) noexcept;
  void makeTexelView(const std::string& name);

  Device* device_ = nullptr;
  VkBuffer buffer_ = VK_NULL_HANDLE;
  VkBufferView texelView_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  std::size_t bytes_ = 0;
  std::size_t allocatedBytes_ = 0;
  bool lent_ = false;
  std::byte* mapped_ = nullptr;
  AccessState state_;
};

}  // namespace opaline::gpu
