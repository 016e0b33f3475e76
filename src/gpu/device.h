#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gpu/access.h"
#include "gpu/retired_objects.h"
#include "gpu/shader.h"
#include "gpu/submissions.h"
#include "gpu/vulkan_functions.h"
#include "gpu/work_groups.h"
#include "opaline/log.h"
#include "opaline/vulkan.h"

namespace opaline::gpu {

class Instance;

enum class DeviceType { Discrete, Integrated, Virtual, Software };

/// "discrete", "integrated", "virtual" or "software".
const char* toString(DeviceType type);

struct DeviceInfo {
  std::uint32_t index = 0;  ///< in the order Vulkan lists them
  std::string name;
  std::string driver;  ///< name and version
  DeviceType type = DeviceType::Software;
  bool rayQueries = false;  ///< has VK_KHR_ray_query
  std::string missing;      ///< what Opaline needs and the device lacks; empty if nothing
};

struct DeviceOptions {
  std::string selector;     ///< index or part of a name (any case); empty: the best there is
  bool validation = false;  ///< load the validation layer, messages go to `log`
  LogCallback log;
  std::vector<std::string> instanceExtensions;  ///< in addition to those that Opaline needs itself
  std::vector<std::string> deviceExtensions;    ///< the same for the device
  std::optional<bool> rayQueries;  ///< whether to use them; empty: if hardware supports them
  std::optional<std::size_t> mostMemoryBytes;  ///< limit for buffers and images together
  const GivenVulkan* given = nullptr;          ///< device to use instead of opening one
  std::span<const std::byte> pipelineCache;    ///< as Device::pipelineCache() returned it
};

/// The device's functions for AccelerationStructure.
struct RayFunctions {
  PFN_vkCreateAccelerationStructureKHR create = nullptr;
  PFN_vkDestroyAccelerationStructureKHR destroy = nullptr;
  PFN_vkGetAccelerationStructureBuildSizesKHR buildSizes = nullptr;
  PFN_vkGetAccelerationStructureDeviceAddressKHR address = nullptr;
  PFN_vkCmdBuildAccelerationStructuresKHR build = nullptr;
  VkDeviceSize scratchAlignment = 0;
};

/// One Vulkan 1.3 device, opened or given, with one queue for graphics, compute and transfer. It
/// numbers submissions from 1 on, and counts the memory of buffers and images.
class Device {
 public:
  /// Prefers discrete, integrated, virtual and software devices in this order. Throws Error when no
  /// Vulkan device meets the needs; UsageError when the selector fits none, ray queries are
  /// requested of a device without them, or a given device lacks something needed.
  explicit Device(const DeviceOptions& options = {});
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  /// Every device of this machine; empty without Vulkan.
  static std::vector<DeviceInfo> list();

  const DeviceInfo& info() const { return info_; }
  VkInstance instance() const { return instance_; }
  VkDevice handle() const { return device_; }
  VkPhysicalDevice physical() const { return physical_; }
  VkQueue queue() const { return queue_; }
  std::uint32_t queueFamily() const { return queueFamily_; }
  const VkPhysicalDeviceLimits& limits() const { return properties_.limits; }

  std::size_t largestBufferBytes() const { return largestBufferBytes_; }

  std::size_t peakMemoryBytes() const { return peakMemoryBytes_; }
  /// Memory of all objects that have not been destroyed.
  std::size_t memoryBytes() const { return memoryBytes_; }
  /// Warnings and errors of the validation layer so far.
  std::size_t validationMessages() const;

  /// Submits command buffers to the queue in order, under its lock, between `waits` and `signals`.
  /// Returns the number of the submission.
  static constexpr std::size_t mostBuffers = 4;
  static constexpr std::size_t mostSemaphores = 16;
  std::uint64_t submit(std::span<const VkCommandBuffer> commands,
                       std::span<const SemaphoreValue> waits = {},
                       std::span<const SemaphoreValue> signals = {});
  /// Numbers work that the caller will submit, as if it were submitted now. `done` is reached when
  /// it has finished.
  std::uint64_t expect(const SemaphoreValue& done) {
    return submissions_.add(done, Submissions::By::Others);
  }
  /// The number of the last submission.
  std::uint64_t submitted() const { return submissions_.last(); }
  /// Blocks until the device has finished a submission and all earlier ones. Throws Error when the
  /// device is lost.
  void waitFor(std::uint64_t submission);

  /// Notes that commands were dropped whose accesses resources remember: the next list waits for
  /// all earlier work.
  void noteAbandoned() { abandoned_ = true; }
  bool takeAbandoned() { return std::exchange(abandoned_, false); }

  /// Destroys an object as soon as the device has finished all that has been submitted so far.
  /// `lent`: submissions of the caller's may use it too; then it also has to wait for the next
  /// submission of this device, which comes after theirs.
  template <typename Handle>
  void retire(VkObjectType type, Handle handle, bool lent = false) {
    retire(type, reinterpret_cast<std::uint64_t>(handle), 0, lent);
  }

  /// How many objects have been retired. While the number stays the same, a valid handle still
  /// means the same object.
  std::uint64_t retired() const { return retired_.count(); }

  /// For Buffer and GpuImage: allocates and counts memory; `addressed` if the buffer's address is
  /// needed. Throws Error when there is none left.
  VkDeviceMemory allocate(const VkMemoryRequirements& requirements, VkMemoryPropertyFlags wanted,
                          VkMemoryPropertyFlags preferred, const std::string& name,
                          bool addressed = false);
  /// Retires memory, as retire() does.
  void release(VkDeviceMemory memory, std::size_t bytes, bool lent = false);

  /// Names an object for debuggers and validation messages, if the device has memory for the name;
  /// costs nothing without VK_EXT_debug_utils.
  void setName(VkObjectType type, std::uint64_t handle, const std::string& name) const;

  /// Debug labels around commands; costs nothing without VK_EXT_debug_utils.
  void beginLabel(VkCommandBuffer commands, const char* name) const;
  void endLabel(VkCommandBuffer commands) const;

  /// Vulkan's functions of this device and of its instance.
  const DeviceFunctions& vk() const { return vk_; }
  const InstanceFunctions& instanceFunctions() const { return ofInstance_; }

  /// For Pipeline: the cache that keeps its compilations.
  VkPipelineCache pipelineCacheHandle() const { return pipelineCache_; }
  /// Data that spares later runs on the same device and driver most compilations.
  std::vector<std::byte> pipelineCache() const;

  /// The order of the commands of all lists.
  CommandOrder& commandOrder() { return commandOrder_; }

  const WorkGroups& workGroups() const { return workGroups_; }

  /// The variant of shaders that suits the device best.
  ShaderVariant shaderVariant() const { return shaderVariant_; }

  /// Whether shaders may send rays through acceleration structures.
  bool hasRayQueries() const { return rays_.build != nullptr; }
  const RayFunctions& rays() const { return rays_; }

 private:
  void openOwn(const DeviceOptions& options);
  void takeGiven(const DeviceOptions& options);
  void readProperties();
  void createDevice(const std::vector<std::string>& wanted, bool rayQueries);
  void loadFunctions(PFN_vkGetInstanceProcAddr load, bool rayQueries);
  void loadRayFunctions();
  void createTimeline();
  void createPipelineCache(std::span<const std::byte> data);
  void destroyObjects();
  void retire(VkObjectType type, std::uint64_t handle, std::size_t bytes, bool lent);
  void waitUntilIdle();
  void destroyRetired();
  bool exceedsLimit(std::size_t bytes) const;
  VkDeviceMemory tryAllocate(const VkMemoryRequirements& requirements, VkMemoryPropertyFlags flags,
                             const std::string& name, bool addressed);

  std::unique_ptr<Instance> ownInstance_;  // null if the device was given
  std::function<void()> lockQueue_;
  std::function<void()> unlockQueue_;
  VkInstance instance_ = VK_NULL_HANDLE;
  InstanceFunctions ofInstance_;
  DeviceFunctions vk_;
  DeviceInfo info_;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  std::uint32_t queueFamily_ = 0;
  VkSemaphore timeline_ = VK_NULL_HANDLE;  // counts the submissions of this device
  std::uint64_t timelineValue_ = 0;        // its value once all of them have finished
  Submissions submissions_;
  bool abandoned_ = false;
  CommandOrder commandOrder_;
  VkPipelineCache pipelineCache_ = VK_NULL_HANDLE;
  RetiredObjects retired_;
  VkPhysicalDeviceProperties properties_{};
  VkPhysicalDeviceMemoryProperties memoryProperties_{};
  WorkGroups workGroups_;
  ShaderVariant shaderVariant_ = ShaderVariant::Texels;
  std::size_t largestAllocationBytes_ = 0;
  std::size_t largestBufferBytes_ = 0;
  std::size_t memoryBytes_ = 0;
  std::size_t peakMemoryBytes_ = 0;
  std::optional<std::size_t> mostMemoryBytes_;
  PFN_vkSetDebugUtilsObjectNameEXT setObjectName_ = nullptr;
  PFN_vkCmdBeginDebugUtilsLabelEXT beginLabel_ = nullptr;
  PFN_vkCmdEndDebugUtilsLabelEXT endLabel_ = nullptr;
  RayFunctions rays_;
};

}  // namespace opaline::gpu
