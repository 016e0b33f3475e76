#pragma once

#include <vulkan/vulkan.h>

namespace opaline::gpu {

// The functions of an instance and of a device that the library calls.
#define OPALINE_INSTANCE_FUNCTIONS(each)                                                           \
  each(vkCreateDevice) each(vkEnumerateDeviceExtensionProperties) each(vkGetDeviceProcAddr)        \
      each(vkGetPhysicalDeviceFeatures2) each(vkGetPhysicalDeviceFormatProperties)                 \
          each(vkGetPhysicalDeviceImageFormatProperties) each(vkGetPhysicalDeviceMemoryProperties) \
              each(vkGetPhysicalDeviceProperties) each(vkGetPhysicalDeviceProperties2)             \
                  each(vkGetPhysicalDeviceQueueFamilyProperties)

#define OPALINE_DEVICE_FUNCTIONS(each)                                                             \
  each(vkAllocateCommandBuffers) each(vkAllocateMemory) each(vkBeginCommandBuffer) each(           \
      vkBindBufferMemory) each(vkBindImageMemory) each(vkCmdBeginRendering)                        \
      each(vkCmdBindIndexBuffer) each(vkCmdBindPipeline) each(vkCmdClearColorImage) each(          \
          vkCmdCopyBuffer) each(vkCmdCopyBufferToImage) each(vkCmdCopyImageToBuffer)               \
          each(vkCmdDispatchBase) each(vkCmdDispatchIndirect) each(vkCmdDraw) each(                \
              vkCmdDrawIndexed) each(vkCmdEndRendering) each(vkCmdExecuteCommands)                 \
              each(vkCmdFillBuffer) each(vkCmdPipelineBarrier2) each(vkCmdPushConstants) each(     \
                  vkCmdPushDescriptorSetKHR) each(vkCmdResetQueryPool) each(vkCmdSetScissor)       \
                  each(vkCmdSetViewport) each(vkCmdWriteTimestamp2) each(vkCreateBuffer) each(     \
                      vkCreateBufferView) each(vkCreateCommandPool) each(vkCreateComputePipelines) \
                      each(vkCreateDescriptorSetLayout) each(vkCreateGraphicsPipelines) each(      \
                          vkCreateImage) each(vkCreateImageView) each(vkCreatePipelineCache)       \
                          each(vkCreatePipelineLayout) each(vkCreateQueryPool) each(               \
                              vkCreateSampler) each(vkCreateSemaphore) each(vkCreateShaderModule)  \
                              each(vkDestroyBuffer) each(vkDestroyBufferView) each(                \
                                  vkDestroyCommandPool) each(vkDestroyDescriptorSetLayout)         \
                                  each(vkDestroyDevice) each(vkDestroyImage)                       \
                                      each(vkDestroyImageView) each(vkDestroyPipeline) each(       \
                                          vkDestroyPipelineCache) each(vkDestroyPipelineLayout)    \
                                          each(vkDestroyQueryPool) each(vkDestroySampler) each(    \
                                              vkDestroySemaphore) each(vkDestroyShaderModule)      \
                                              each(vkDeviceWaitIdle) each(vkEndCommandBuffer)      \
                                                  each(vkFreeMemory)                               \
                                                      each(vkGetBufferDeviceAddress) each(         \
                                                          vkGetBufferMemoryRequirements)           \
                                                          each(vkGetDeviceQueue) each(             \
                                                              vkGetImageMemoryRequirements)        \
                                                              each(vkGetPipelineCacheData) each(   \
                                                                  vkGetQueryPoolResults)           \
                                                                  each(vkGetSemaphoreCounterValue) \
                                                                      each(vkMapMemory) each(      \
                                                                          vkQueueSubmit2)          \
                                                                          each(vkWaitSemaphores)

#define OPALINE_FUNCTION_MEMBER(name) PFN_##name name = nullptr;

/// Vulkan's functions of one instance.
struct InstanceFunctions {
  OPALINE_INSTANCE_FUNCTIONS(OPALINE_FUNCTION_MEMBER)
};

/// Vulkan's functions of one device, without the detour through the loader.
struct DeviceFunctions {
  OPALINE_DEVICE_FUNCTIONS(OPALINE_FUNCTION_MEMBER)
};

#undef OPALINE_FUNCTION_MEMBER

/// Load functions by `load`, which belongs to the maker of the instance. vkGetInstanceProcAddr
/// itself means the loader that the library is linked with. Throw Error for a function that does
/// not exist.
InstanceFunctions loadInstanceFunctions(PFN_vkGetInstanceProcAddr load, VkInstance instance);
DeviceFunctions loadDeviceFunctions(const InstanceFunctions& functions, VkDevice device);

}  // namespace opaline::gpu
