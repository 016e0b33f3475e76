#pragma once

#include <opaline/vulkan.h>
#include <vulkan/vulkan.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <vector>

#include "camera.h"

/// What any engine has: a device, a queue that its threads share under a lock, memory, pipelines.
/// It only uses the library to ask what the device needs.
class Engine {
 public:
  /// `validation` enables Vulkan's validation layer, including synchronization.
  explicit Engine(bool validation);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// The device in the form that the library takes.
  opaline::GivenVulkan given();
  /// The number of messages from the validation layer.
  int complaints() const { return complaints_; }

  struct Buffer {
    VkBuffer buffer = VK_NULL_HANDLE;
    void* mapped = nullptr;
  };
  Buffer makeBuffer(std::size_t bytes, VkBufferUsageFlags usage);
  struct Image {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkImageAspectFlags aspect = 0;
  };
  Image makeImage(VkFormat format, VkExtent2D extent, VkImageUsageFlags usage,
                  VkImageAspectFlags aspect);
  VkSemaphore makeTimeline();
  /// A command buffer with its own pool, so that every thread can have one.
  struct Commands {
    VkCommandPool pool = VK_NULL_HANDLE;
    VkCommandBuffer buffer = VK_NULL_HANDLE;
  };
  Commands makeCommands();

  /// Begins the command buffer again; the device must have finished its earlier commands.
  VkCommandBuffer begin(const Commands& commands);
  /// Ends it and submits it under the lock; may be called from any thread.
  void submit(VkCommandBuffer commands, const opaline::TimelinePoint& wait,
              const opaline::TimelinePoint& signal);
  void waitFor(const opaline::TimelinePoint& point);

  /// Records the wave of the vertices from `rest` to `positions`.
  void wave(VkCommandBuffer commands, VkBuffer rest, VkBuffer positions, std::uint32_t vertices,
            float seconds);
  /// Clears colour and depth and draws the floor at that height.
  void drawFloor(VkCommandBuffer commands, const Image& color, const Image& depth,
                 VkExtent2D extent, const Camera& camera, float heightMm);
  /// Copies colour to a buffer.
  void copy(VkCommandBuffer commands, const Image& color, VkExtent2D extent, VkBuffer to);

 private:
  void makeInstance(bool validation);
  void makeDevice();
  VkShaderModule makeModule(const std::uint32_t* code, std::size_t bytes);
  void makeWave();
  void makeFloor();
  VkDeviceMemory allocate(const VkMemoryRequirements& requirements, VkMemoryPropertyFlags flags);

  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  std::uint32_t family_ = 0;
  VkQueue queue_ = VK_NULL_HANDLE;
  std::mutex queueMutex_;
  std::atomic<int> complaints_ = 0;
  PFN_vkCmdPushDescriptorSetKHR pushDescriptors_ = nullptr;
  VkDescriptorSetLayout waveSet_ = VK_NULL_HANDLE;
  VkPipelineLayout waveLayout_ = VK_NULL_HANDLE;
  VkPipeline wave_ = VK_NULL_HANDLE;
  VkPipelineLayout floorLayout_ = VK_NULL_HANDLE;
  VkPipeline floor_ = VK_NULL_HANDLE;
  std::vector<VkDeviceMemory> memories_;
  std::vector<VkBuffer> buffers_;
  std::vector<Image> images_;
  std::vector<VkSemaphore> semaphores_;
  std::vector<VkCommandPool> pools_;
};
