#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "opaline/renderer.h"
#include "opaline/vulkan.h"

namespace opaline::test {

/// A program with its own Vulkan device, made as vulkanNeeds() requires, with or without
/// synchronization validation. Counts what the library does with the queue. Command buffers,
/// submissions, timelines and buffers may be made on any thread, which each have their own.
class Engine {
 public:
  explicit Engine(bool validated = true);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// The device as given to the library. A mutex of the engine locks its queue.
  GivenVulkan given();
  RendererOptions options() { return {.given = given()}; }

  /// Warnings and errors of the validation layer.
  std::vector<std::string> messages() const;
  /// Calls of vkQueueSubmit2 by the library, and of vkDeviceWaitIdle and vkQueueWaitIdle.
  static int submissions();
  static int waitsForIdle();
  /// Makes the library's submissions and waits fail as if the device were lost, or succeed again.
  static void loseDevice(bool lost);
  /// How often the library held the lock.
  int locks() const { return locks_; }

  VkDevice device() const { return device_; }
  VkPhysicalDevice physicalDevice() const { return physical_; }
  VkInstance instance() const { return instance_; }
  VkSemaphore timeline() { return lane().timeline; }
  /// A new value of the timeline, for something that will signal it.
  TimelinePoint nextPoint() {
    Lane& own = lane();
    return {own.timeline, ++own.lastPoint};
  }

  /// Memory that everyone may use, freed with the engine.
  struct Memory {
    VkDeviceMemory memory = VK_NULL_HANDLE;
    std::byte* mapped = nullptr;
  };
  struct HostBuffer {
    VkBuffer buffer = VK_NULL_HANDLE;
    std::byte* mapped = nullptr;
  };
  HostBuffer makeBuffer(std::size_t bytes, VkBufferUsageFlags usage);
  struct Target {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkExtent2D extent{};
    VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
  };
  Target makeTarget(VkFormat format, VkExtent2D extent,
                    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT);

  /// A command buffer that has begun, from a pool of the engine.
  VkCommandBuffer begin();
  /// Ends it and submits it under the lock, after `waits`; signals the point.
  void submit(VkCommandBuffer commands, const TimelinePoint& point,
              const std::vector<TimelinePoint>& waits = {});
  void waitFor(const TimelinePoint& point) const;
  /// Signals from the host, for work that waits for the point.
  void signal(const TimelinePoint& point) const;
  /// Records commands, submits them and waits.
  void run(const std::function<void(VkCommandBuffer)>& record);

  /// A render pass without draws: clears the targets and leaves them as attachments.
  static void clear(VkCommandBuffer commands, const Target& color, const VkClearColorValue& value,
                    const Target& depth, float depthValue);
  /// The texels of a target that was left as an attachment, four bytes or four floats each.
  std::vector<float> read(const Target& target);
  /// The same for the library's images of four floats R G B A, in their stated layout.
  std::vector<float> read(const DeviceImage& image);
  /// Resolves a multisampled colour into a target with one sample.
  void resolve(const Target& from, const Target& to);

 private:
  /// What each thread owns.
  struct Lane {
    VkSemaphore timeline = VK_NULL_HANDLE;
    VkCommandPool pool = VK_NULL_HANDLE;
    std::uint64_t lastPoint = 0;
  };
  Lane& lane();
  void makeInstance(bool validated);
  void listen();
  void makeDevice();
  void copy(const Target& target, VkImageLayout layout, const HostBuffer& buffer);
  std::vector<float> readAs(const Target& target, VkImageLayout layout);
  Memory allocate(const VkMemoryRequirements& requirements, VkMemoryPropertyFlags flags);

  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  std::mutex laneMutex_;
  std::map<std::thread::id, Lane> lanes_;
  std::mutex queueMutex_;
  int locks_ = 0;
  mutable std::mutex messageMutex_;
  std::vector<std::string> messages_;
  std::vector<VkBuffer> buffers_;
  std::vector<VkDeviceMemory> memories_;
  std::vector<Target> targets_;
};

}  // namespace opaline::test
