#include "gpu/retired_objects.h"

#include <algorithm>
#include <cassert>

#include "gpu/device.h"
#include "gpu/vulkan_functions.h"

namespace opaline::gpu {

namespace {

template <typename Handle>
Handle as(std::uint64_t handle) {
  return reinterpret_cast<Handle>(handle);
}

}  // namespace

void RetiredObjects::destroy(VkObjectType type, std::uint64_t handle, VkDevice device,
                             const DeviceFunctions& vk, const RayFunctions& rays) {
  switch (type) {
    case VK_OBJECT_TYPE_BUFFER:
      return vk.vkDestroyBuffer(device, as<VkBuffer>(handle), nullptr);
    case VK_OBJECT_TYPE_BUFFER_VIEW:
      return vk.vkDestroyBufferView(device, as<VkBufferView>(handle), nullptr);
    case VK_OBJECT_TYPE_IMAGE:
      return vk.vkDestroyImage(device, as<VkImage>(handle), nullptr);
    case VK_OBJECT_TYPE_IMAGE_VIEW:
      return vk.vkDestroyImageView(device, as<VkImageView>(handle), nullptr);
    case VK_OBJECT_TYPE_SAMPLER:
      return vk.vkDestroySampler(device, as<VkSampler>(handle), nullptr);
    case VK_OBJECT_TYPE_DEVICE_MEMORY:
      return vk.vkFreeMemory(device, as<VkDeviceMemory>(handle), nullptr);
    case VK_OBJECT_TYPE_PIPELINE:
      return vk.vkDestroyPipeline(device, as<VkPipeline>(handle), nullptr);
    case VK_OBJECT_TYPE_PIPELINE_LAYOUT:
      return vk.vkDestroyPipelineLayout(device, as<VkPipelineLayout>(handle), nullptr);
    case VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT:
      return vk.vkDestroyDescriptorSetLayout(device, as<VkDescriptorSetLayout>(handle), nullptr);
    case VK_OBJECT_TYPE_COMMAND_POOL:
      return vk.vkDestroyCommandPool(device, as<VkCommandPool>(handle), nullptr);
    case VK_OBJECT_TYPE_QUERY_POOL:
      return vk.vkDestroyQueryPool(device, as<VkQueryPool>(handle), nullptr);
    case VK_OBJECT_TYPE_ACCELERATION_STRUCTURE_KHR:
      return rays.destroy(device, as<VkAccelerationStructureKHR>(handle), nullptr);
    default:
      assert(false && "nothing of this type is retired");
  }
}

void RetiredObjects::add(std::uint64_t submission, VkObjectType type, std::uint64_t handle,
                         std::size_t bytes) {
  ++count_;
  objects_.push_back({submission, type, handle, bytes});
}

std::size_t RetiredObjects::destroyUpTo(std::uint64_t submission, VkDevice device,
                                        const DeviceFunctions& vk, const RayFunctions& rays) {
  std::size_t freed = 0;
  const auto isDone = [&](const Object& object) {
    if (object.submission > submission) return false;
    destroy(object.type, object.handle, device, vk, rays);
    freed += object.bytes;
    return true;
  };
  objects_.erase(std::remove_if(objects_.begin(), objects_.end(), isDone), objects_.end());
  return freed;
}

}  // namespace opaline::gpu
