#include "viewer/picture/host_picture.h"

#include <cstdint>
#include <cstring>
#include <vector>

#include "opaline/error.h"
#include "viewer/window/vulkan_check.h"
#include "viewer/window/vulkan_objects.h"

namespace opaline::app::viewer {

namespace {

constexpr VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT;
constexpr const char* attempt = "show a picture";

void order(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to) {
  VkImageMemoryBarrier barrier{};
  barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
  barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
  barrier.oldLayout = from;
  barrier.newLayout = to;
  barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image;
  barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                       VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0, nullptr, 0, nullptr, 1, &barrier);
}

/// A buffer that the host fills and the device reads.
struct Staging {
  explicit Staging(VkDevice owner) : device(owner) {}
  ~Staging() {
    vkDestroyBuffer(device, buffer, nullptr);
    vkFreeMemory(device, memory, nullptr);
  }
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;

  VkDevice device;
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceMemory memory = VK_NULL_HANDLE;
};

}  // namespace

HostPicture::~HostPicture() {
  clear();
}

void HostPicture::clear() {
  if (shown_.image == VK_NULL_HANDLE) return;
  vkDeviceWaitIdle(device_.device);
  vkDestroyImageView(device_.device, shown_.view, nullptr);
  vkDestroyImage(device_.device, shown_.image, nullptr);
  vkFreeMemory(device_.device, memory_, nullptr);
  shown_ = {};
  memory_ = VK_NULL_HANDLE;
}

void HostPicture::set(const Image& image) {
  const VkExtent2D extent{static_cast<std::uint32_t>(image.width),
                          static_cast<std::uint32_t>(image.height)};
  if (extent.width == 0 || extent.height == 0) return clear();
  if (extent.width != shown_.extent.width || extent.height != shown_.extent.height) {
    clear();
    makeImage(extent);
  }
  // Light times coverage, as in the renderer's own pictures.
  std::vector<float> texels = image.rgba;
  for (std::size_t i = 0; i < texels.size(); i += 4) {
    for (std::size_t c = 0; c < 3; ++c) texels[i + c] *= texels[i + 3];
  }
  upload(texels.data(), texels.size() * sizeof(float));
}

VkDeviceMemory HostPicture::allocate(const VkMemoryRequirements& needs,
                                     VkMemoryPropertyFlags wanted) const {
  VkPhysicalDeviceMemoryProperties memory{};
  vkGetPhysicalDeviceMemoryProperties(device_.physicalDevice, &memory);
  for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
    if ((needs.memoryTypeBits & (1U << i)) == 0) continue;
    if ((memory.memoryTypes[i].propertyFlags & wanted) != wanted) continue;
    VkMemoryAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = needs.size;
    info.memoryTypeIndex = i;
    VkDeviceMemory made = VK_NULL_HANDLE;
    check(vkAllocateMemory(device_.device, &info, nullptr, &made), attempt);
    return made;
  }
  throw Error("the device has no memory for a picture of the window");
}

void HostPicture::makeImage(VkExtent2D extent) {
  VkImageCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = format;
  info.extent = {extent.width, extent.height, 1};
  info.mipLevels = 1;
  info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  check(vkCreateImage(device_.device, &info, nullptr, &shown_.image), attempt);
  VkMemoryRequirements needs{};
  vkGetImageMemoryRequirements(device_.device, shown_.image, &needs);
  memory_ = allocate(needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  check(vkBindImageMemory(device_.device, shown_.image, memory_, 0), attempt);
  shown_.view = makeView(device_.device, shown_.image, format, attempt);
  shown_.format = format;
  shown_.layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
  shown_.extent = extent;
}

void HostPicture::upload(const void* texels, std::size_t bytes) {
  check(vkDeviceWaitIdle(device_.device), attempt);
  VkBufferCreateInfo bufferInfo{};
  bufferInfo.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  bufferInfo.size = bytes;
  bufferInfo.usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
  Staging staging{device_.device};
  check(vkCreateBuffer(device_.device, &bufferInfo, nullptr, &staging.buffer), attempt);
  VkMemoryRequirements needs{};
  vkGetBufferMemoryRequirements(device_.device, staging.buffer, &needs);
  staging.memory =
      allocate(needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
  check(vkBindBufferMemory(device_.device, staging.buffer, staging.memory, 0), attempt);
  void* mapped = nullptr;
  check(vkMapMemory(device_.device, staging.memory, 0, VK_WHOLE_SIZE, 0, &mapped), attempt);
  std::memcpy(mapped, texels, bytes);

  const auto copy = [&](VkCommandBuffer commands) {
    order(commands, shown_.image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    VkBufferImageCopy all{};
    all.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    all.imageExtent = {shown_.extent.width, shown_.extent.height, 1};
    vkCmdCopyBufferToImage(commands, staging.buffer, shown_.image,
                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &all);
    order(commands, shown_.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, shown_.layout);
  };
  runOnce(device_, copy, attempt);
}

}  // namespace opaline::app::viewer
