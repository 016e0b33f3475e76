#include "gpu/device.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <new>
#include <type_traits>

#include "gpu/device_choice.h"
#include "gpu/host_room.h"
#include "gpu/instance.h"
#include "gpu/vulkan_result.h"
#include "opaline/error.h"

namespace opaline::gpu {

namespace {

/// Kinds of memory that only special features or attachments may use.
constexpr VkMemoryPropertyFlags specialMemory =
    VK_MEMORY_PROPERTY_LAZILY_ALLOCATED_BIT | VK_MEMORY_PROPERTY_PROTECTED_BIT |
    VK_MEMORY_PROPERTY_DEVICE_COHERENT_BIT_AMD | VK_MEMORY_PROPERTY_DEVICE_UNCACHED_BIT_AMD;

Error outOfMemory(const std::string& name, std::size_t bytes, const std::string& device) {
  return Error(
      fmt::format("\"{}\" needs {:.1f} MB, which does not fit into the memory of {}; use a smaller "
                  "image or map, "
                  "or another device",
                  name, static_cast<double>(bytes) / 1e6, device));
}

VkSemaphoreSubmitInfo submitInfoOf(const SemaphoreValue& point) {
  VkSemaphoreSubmitInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO;
  info.semaphore = point.semaphore;
  info.value = point.value;
  info.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  return info;
}

// Held while the queue is used, if its owner shares it with other threads.
class QueueLock {
 public:
  QueueLock(const std::function<void()>& lock, const std::function<void()>& unlock)
      : unlock_(unlock) {
    if (lock) lock();
  }
  ~QueueLock() {
    if (unlock_) unlock_();
  }
  QueueLock(const QueueLock&) = delete;
  QueueLock& operator=(const QueueLock&) = delete;

 private:
  const std::function<void()>& unlock_;
};

Error beyondLimit(const std::string& name, std::size_t bytes, std::size_t taken,
                  std::size_t limit) {
  return Error(
      fmt::format("\"{}\" needs {:.1f} MB, but {:.1f} MB of the {:g} MB allowed are already in "
                  "use; use a smaller image or map, or raise the memory limit",
                  name, static_cast<double>(bytes) / 1e6, static_cast<double>(taken) / 1e6,
                  static_cast<double>(limit) / 1e6));
}

}  // namespace

const char* toString(DeviceType type) {
  switch (type) {
    case DeviceType::Discrete:
      return "discrete";
    case DeviceType::Integrated:
      return "integrated";
    case DeviceType::Virtual:
      return "virtual";
    case DeviceType::Software:
      return "software";
  }
  assert(false);
  return "";
}

void Device::destroyObjects() {
  if (vk_.vkDestroyDevice == nullptr) {  // an exception came before the functions were loaded
    if (!ownInstance_ || device_ == VK_NULL_HANDLE) return;
    const PFN_vkVoidFunction destroy = ofInstance_.vkGetDeviceProcAddr(device_, "vkDestroyDevice");
    if (destroy != nullptr) reinterpret_cast<PFN_vkDestroyDevice>(destroy)(device_, nullptr);
    return;
  }
  retired_.destroyUpTo(UINT64_MAX, device_, vk_, rays_);
  vk_.vkDestroyPipelineCache(device_, pipelineCache_, nullptr);
  vk_.vkDestroySemaphore(device_, timeline_, nullptr);
  if (ownInstance_) vk_.vkDestroyDevice(device_, nullptr);
}

Device::~Device() {
  waitUntilIdle();
  destroyObjects();
}

std::size_t Device::validationMessages() const {
  return ownInstance_ ? ownInstance_->messages() : 0;
}

std::uint64_t Device::submit(std::span<const VkCommandBuffer> commands,
                             std::span<const SemaphoreValue> waits,
                             std::span<const SemaphoreValue> signals) {
  assert(commands.size() <= mostBuffers);
  assert(waits.size() <= mostSemaphores && signals.size() <= mostSemaphores);
  destroyRetired();
  std::array<VkCommandBufferSubmitInfo, mostBuffers> buffers{};
  for (std::size_t i = 0; i < commands.size(); ++i) {
    buffers[i].sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
    buffers[i].commandBuffer = commands[i];
  }
  std::array<VkSemaphoreSubmitInfo, mostSemaphores> waited{};
  for (std::size_t i = 0; i < waits.size(); ++i) waited[i] = submitInfoOf(waits[i]);
  std::array<VkSemaphoreSubmitInfo, mostSemaphores + 1> signaled{};
  for (std::size_t i = 0; i < signals.size(); ++i) signaled[i] = submitInfoOf(signals[i]);
  const SemaphoreValue done{timeline_, timelineValue_ + 1};
  signaled[signals.size()] = submitInfoOf(done);
  VkSubmitInfo2 info{};
  info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
  info.waitSemaphoreInfoCount = static_cast<std::uint32_t>(waits.size());
  info.pWaitSemaphoreInfos = waited.data();
  info.commandBufferInfoCount = static_cast<std::uint32_t>(commands.size());
  info.pCommandBufferInfos = buffers.data();
  info.signalSemaphoreInfoCount = static_cast<std::uint32_t>(signals.size() + 1);
  info.pSignalSemaphoreInfos = signaled.data();
  // Software devices compile draws at submission, for the state that they meet.
  if (info_.type == DeviceType::Software)
    requireHostRoom(roomToCompile, "submit work to the device");
  submissions_.makeRoom();
  const QueueLock lock(lockQueue_, unlockQueue_);
  check(vk_.vkQueueSubmit2(queue_, 1, &info, VK_NULL_HANDLE), "submit work to the device");
  timelineValue_ = done.value;
  return submissions_.add(done, Submissions::By::Device);
}

void Device::waitFor(std::uint64_t submission) {
  submissions_.waitFor(submission, vk_, device_);
  destroyRetired();
}

// A wait that fails for lack of memory is repeated, because objects in use must not be destroyed.
// On a given device it waits only for our own work: others may use the device and its queues.
void Device::waitUntilIdle() {
  constexpr int attempts = 100;
  for (int i = 0; i < attempts; ++i) {
    const VkResult result = ownInstance_ ? vk_.vkDeviceWaitIdle(device_)
                                         : submissions_.tryWaitFor(submitted(), vk_, device_);
    if (result != VK_ERROR_OUT_OF_HOST_MEMORY && result != VK_ERROR_OUT_OF_DEVICE_MEMORY) return;
  }
}

void Device::retire(VkObjectType type, std::uint64_t handle, std::size_t bytes, bool lent) {
  if (handle == 0) return;
  try {
    retired_.add(lent ? submitted() + 1 : submitted(), type, handle, bytes);
  } catch (const std::bad_alloc&) {  // called by destructors, which must not throw
    waitUntilIdle();
    RetiredObjects::destroy(type, handle, device_, vk_, rays_);
    memoryBytes_ -= bytes;
  }
  destroyRetired();
}

void Device::destroyRetired() {
  if (retired_.empty()) return;
  memoryBytes_ -= retired_.destroyUpTo(submissions_.finished(vk_, device_), device_, vk_, rays_);
}

VkDeviceMemory Device::tryAllocate(const VkMemoryRequirements& requirements,
                                   VkMemoryPropertyFlags flags, const std::string& name,
                                   bool addressed) {
  for (std::uint32_t i = 0; i < memoryProperties_.memoryTypeCount; ++i) {
    const VkMemoryType& type = memoryProperties_.memoryTypes[i];
    if ((requirements.memoryTypeBits & (1U << i)) == 0) continue;
    if ((type.propertyFlags & flags) != flags) continue;
    if ((type.propertyFlags & specialMemory) != 0) continue;
    if (requirements.size > memoryProperties_.memoryHeaps[type.heapIndex].size) continue;
    VkMemoryAllocateFlagsInfo address{};
    address.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO;
    address.flags = VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT;
    VkMemoryAllocateInfo info{};
    if (addressed) info.pNext = &address;
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = requirements.size;
    info.memoryTypeIndex = i;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    const VkResult result = vk_.vkAllocateMemory(device_, &info, nullptr, &memory);
    if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY) continue;
    if (result < 0) check(result, fmt::format("find memory for \"{}\"", name));
    return memory;
  }
  return VK_NULL_HANDLE;
}

bool Device::exceedsLimit(std::size_t bytes) const {
  return mostMemoryBytes_ && bytes > *mostMemoryBytes_ - std::min(memoryBytes_, *mostMemoryBytes_);
}

VkDeviceMemory Device::allocate(const VkMemoryRequirements& requirements,
                                VkMemoryPropertyFlags wanted, VkMemoryPropertyFlags preferred,
                                const std::string& name, bool addressed) {
  if (requirements.size > largestAllocationBytes_) {
    throw outOfMemory(name, requirements.size, info_.name);
  }
  const auto tryBoth = [&] {
    if (exceedsLimit(requirements.size)) return VkDeviceMemory{VK_NULL_HANDLE};
    const VkDeviceMemory best = tryAllocate(requirements, wanted | preferred, name, addressed);
    return best != VK_NULL_HANDLE ? best : tryAllocate(requirements, wanted, name, addressed);
  };
  destroyRetired();
  VkDeviceMemory memory = tryBoth();
  if (memory == VK_NULL_HANDLE && !retired_.empty()) {
    waitFor(submitted());
    memory = tryBoth();
  }
  if (memory == VK_NULL_HANDLE && exceedsLimit(requirements.size))
    throw beyondLimit(name, requirements.size, memoryBytes_, *mostMemoryBytes_);
  if (memory == VK_NULL_HANDLE) throw outOfMemory(name, requirements.size, info_.name);
  memoryBytes_ += requirements.size;
  peakMemoryBytes_ = std::max(peakMemoryBytes_, memoryBytes_);
  setName(VK_OBJECT_TYPE_DEVICE_MEMORY, reinterpret_cast<std::uint64_t>(memory), name);
  return memory;
}

void Device::release(VkDeviceMemory memory, std::size_t bytes, bool lent) {
  retire(VK_OBJECT_TYPE_DEVICE_MEMORY, reinterpret_cast<std::uint64_t>(memory), bytes, lent);
}

void Device::setName(VkObjectType type, std::uint64_t handle, const std::string& name) const {
  if (setObjectName_ == nullptr) return;
  VkDebugUtilsObjectNameInfoEXT info{};
  info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT;
  info.objectType = type;
  info.objectHandle = handle;
  info.pObjectName = name.c_str();
  setObjectName_(device_, &info);  // a failure does no harm
}

void Device::beginLabel(VkCommandBuffer commands, const char* name) const {
  if (beginLabel_ == nullptr) return;
  VkDebugUtilsLabelEXT label{};
  label.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT;
  label.pLabelName = name;
  beginLabel_(commands, &label);
}

void Device::endLabel(VkCommandBuffer commands) const {
  if (endLabel_ != nullptr) endLabel_(commands);
}

}  // namespace opaline::gpu
