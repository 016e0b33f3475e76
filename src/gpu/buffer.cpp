#include "gpu/buffer.h"

#include <fmt/core.h>

#include <cassert>
#include <utility>

#include "gpu/device.h"
#include "gpu/vulkan_result.h"
#include "opaline/error.h"

namespace opaline::gpu {

namespace {

struct MemoryKind {
  VkMemoryPropertyFlags wanted = 0;
  VkMemoryPropertyFlags preferred = 0;
};

MemoryKind kindOf(Memory memory) {
  constexpr VkMemoryPropertyFlags visible =
      VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  switch (memory) {
    case Memory::Device:
      return {0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT};
    case Memory::Upload:
      return {visible, 0};
    case Memory::Readback:
      return {visible, VK_MEMORY_PROPERTY_HOST_CACHED_BIT};
  }
  assert(false);
  return {};
}

void checkSize(const Device& device, const BufferOptions& options) {
  const std::size_t storageLimit = device.limits().maxStorageBufferRange;
  if ((options.usage & VK_BUFFER_USAGE_STORAGE_BUFFER_BIT) != 0 && options.bytes > storageLimit) {
    throw Error(fmt::format(
        "the buffer \"{}\" needs {:.1f} MB, but {} reads at most {:.1f} MB from one buffer; use a "
        "smaller mesh or map, fewer surfels, or another device",
        options.name, static_cast<double>(options.bytes) / 1e6, device.info().name,
        static_cast<double>(storageLimit) / 1e6));
  }
  if (options.bytes > device.largestBufferBytes()) {
    throw Error(fmt::format(
        "the buffer \"{}\" needs {:.1f} MB, which is more than {} allows; use a smaller mesh or "
        "map, fewer surfels, or another device",
        options.name, static_cast<double>(options.bytes) / 1e6, device.info().name));
  }
}

}  // namespace

Buffer::Buffer(Device& device, const BufferOptions& options) : Buffer() {
  assert(options.bytes > 0);
  checkSize(device, options);
  device_ = &device;
  bytes_ = options.bytes;
  lent_ = options.lent;

  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = options.bytes;
  info.usage = options.usage | VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
  check(device.vk().vkCreateBuffer(device.handle(), &info, nullptr, &buffer_),
        fmt::format("create the buffer \"{}\"", options.name));
  device.setName(VK_OBJECT_TYPE_BUFFER, reinterpret_cast<std::uint64_t>(buffer_), options.name);

  VkMemoryRequirements requirements{};
  device.vk().vkGetBufferMemoryRequirements(device.handle(), buffer_, &requirements);
  const MemoryKind kind = kindOf(options.memory);
  const bool addressed = (options.usage & VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT) != 0;
  memory_ = device.allocate(requirements, kind.wanted, kind.preferred, options.name, addressed);
  allocatedBytes_ = requirements.size;
  check(device.vk().vkBindBufferMemory(device.handle(), buffer_, memory_, 0),
        fmt::format("give memory to the buffer \"{}\"", options.name));
  if (options.memory != Memory::Device) {
    void* mapped = nullptr;
    check(device.vk().vkMapMemory(device.handle(), memory_, 0, VK_WHOLE_SIZE, 0, &mapped),
          fmt::format("map the buffer \"{}\"", options.name));
    mapped_ = static_cast<std::byte*>(mapped);
  }
  if ((options.usage & VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT) != 0) makeTexelView(options.name);
}

void Buffer::makeTexelView(const std::string& name) {
  constexpr std::size_t texelBytes = 4 * sizeof(float);
  const std::size_t most = device_->limits().maxTexelBufferElements;
  if (bytes_ / texelBytes > most) {
    throw Error(fmt::format(
        "the buffer \"{}\" needs {} texels, but {} reads at most {} from one buffer; use fewer "
        "surfels, or another device",
        name, bytes_ / texelBytes, device_->info().name, most));
  }
  VkBufferViewCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO;
  info.buffer = buffer_;
  info.format = VK_FORMAT_R32G32B32A32_SFLOAT;
  info.range = bytes_ / texelBytes * texelBytes;
  check(device_->vk().vkCreateBufferView(device_->handle(), &info, nullptr, &texelView_),
        fmt::format("make texels of the buffer \"{}\"", name));
  device_->setName(VK_OBJECT_TYPE_BUFFER_VIEW, reinterpret_cast<std::uint64_t>(texelView_), name);
}

VkDeviceAddress Buffer::address() const {
  VkBufferDeviceAddressInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO;
  info.buffer = buffer_;
  return device_->vk().vkGetBufferDeviceAddress(device_->handle(), &info);
}

Buffer Buffer::borrowed(VkBuffer buffer, std::size_t bytes) {
  assert(buffer != VK_NULL_HANDLE);
  Buffer result;
  result.buffer_ = buffer;
  result.bytes_ = bytes;
  return result;
}

Buffer::~Buffer() {
  if (device_ == nullptr) return;
  device_->retire(VK_OBJECT_TYPE_BUFFER_VIEW, texelView_, lent_);
  device_->retire(VK_OBJECT_TYPE_BUFFER, buffer_, lent_);
  device_->release(memory_, allocatedBytes_, lent_);
}

Buffer::Buffer(Buffer&& other) noexcept {
  swap(other);
}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
  Buffer taken(std::move(other));
  swap(taken);
  return *this;
}

void Buffer::swap(Buffer& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(buffer_, other.buffer_);
  std::swap(texelView_, other.texelView_);
  std::swap(memory_, other.memory_);
  std::swap(bytes_, other.bytes_);
  std::swap(allocatedBytes_, other.allocatedBytes_);
  std::swap(lent_, other.lent_);
  std::swap(mapped_, other.mapped_);
  std::swap(state_, other.state_);
}

}  // namespace opaline::gpu
