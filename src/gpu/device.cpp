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

std::vector<DeviceInfo> describeAll(const std::vector<VkPhysicalDevice>& devices) {
  std::vector<DeviceInfo> infos;
  infos.reserve(devices.size());
  for (const VkPhysicalDevice device : devices) {
    infos.push_back(describe(device, static_cast<std::uint32_t>(infos.size())));
  }
  return infos;
}

// A software device has no hardware for rays: compute shaders, which know what they are looking
// for, are faster there.
bool usesRayQueries(const DeviceInfo& info, std::optional<bool> wanted) {
  if (wanted == true && !info.rayQueries) {
    throw UsageError(
        fmt::format("the Vulkan device {} has no ray queries (VK_KHR_ray_query); update its driver "
                    "or leave rays to compute shaders",
                    info.name));
  }
  return wanted.value_or(info.rayQueries && info.type != DeviceType::Software);
}

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

Error beyondLimit(const std::string& name, std::size_t bytes, std::size_t taken,
                  std::size_t limit) {
  return Error(fmt::format(
      "\"{}\" needs {:.1f} MB, but of {:.1f} MB that may be taken {:.1f} are; use a smaller image "
      "or map, or raise RendererOptions::memoryLimit",
      name, static_cast<double>(bytes) / 1e6, static_cast<double>(limit) / 1e6,
      static_cast<double>(taken) / 1e6));
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

std::vector<DeviceInfo> Device::list() {
  try {
    return describeAll(Instance().physicalDevices());
  } catch (const Error& error) {
    if (std::string(error.what()) == noDeviceMessage) return {};
    throw;
  }
}

Device::Device(const DeviceOptions& options)
    : instance_(
          std::make_unique<Instance>(options.validation, options.log, options.instanceExtensions)),
      mostMemoryBytes_(options.mostMemoryBytes) {
  const std::vector<VkPhysicalDevice> devices = instance_->physicalDevices();
  const std::vector<DeviceInfo> infos = describeAll(devices);
  const std::size_t chosen = choose(infos, options.selector);
  info_ = infos[chosen];
  physical_ = devices[chosen];
  queueFamily_ = findQueueFamily(physical_).value();

  VkPhysicalDeviceMaintenance4Properties buffers{};
  buffers.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_4_PROPERTIES;
  VkPhysicalDeviceMaintenance3Properties maintenance{};
  maintenance.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES;
  maintenance.pNext = &buffers;
  VkPhysicalDeviceProperties2 properties{};
  properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
  properties.pNext = &maintenance;
  vkGetPhysicalDeviceProperties2(physical_, &properties);
  properties_ = properties.properties;
  largestBufferBytes_ = buffers.maxBufferSize;
  largestAllocationBytes_ = maintenance.maxMemoryAllocationSize;
  vkGetPhysicalDeviceMemoryProperties(physical_, &memoryProperties_);

  const bool rayQueries = usesRayQueries(info_, options.rayQueries);
  createDevice(options.deviceExtensions, rayQueries);
  loadFunctions();
  if (rayQueries) loadRayFunctions();
  vkGetDeviceQueue(device_, queueFamily_, 0, &queue_);
  setName(VK_OBJECT_TYPE_QUEUE, reinterpret_cast<std::uint64_t>(queue_), "queue");
  try {
    createTimeline();
  } catch (...) {
    vkDestroyDevice(device_, nullptr);
    throw;
  }
}

void Device::createDevice(const std::vector<std::string>& wanted, bool rayQueries) {
  Features features;
  if (rayQueries) {
    features.chainRayQueries();
    features.addresses.bufferDeviceAddress = VK_TRUE;
    features.structures.accelerationStructure = VK_TRUE;
    features.rayQueries.rayQuery = VK_TRUE;
  }
  features.base.features.imageCubeArray = VK_TRUE;
  features.base.features.independentBlend = VK_TRUE;
  features.vulkan13.dynamicRendering = VK_TRUE;
  features.vulkan13.synchronization2 = VK_TRUE;
  features.timeline.timelineSemaphore = VK_TRUE;
  // What glslc's SPIR-V 1.6 asks for: work-group sizes by specialization constant, and `discard`.
  features.vulkan13.maintenance4 = VK_TRUE;
  features.vulkan13.shaderDemoteToHelperInvocation = VK_TRUE;
  features.vulkan13.shaderTerminateInvocation = VK_TRUE;

  const float priority = 1.0F;
  VkDeviceQueueCreateInfo queue{};
  queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
  queue.queueFamilyIndex = queueFamily_;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  std::vector<const char*> extensions{VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME};
  if (rayQueries) extensions.insert(extensions.end(), rayExtensions.begin(), rayExtensions.end());
  for (const std::string& name : wanted) extensions.push_back(name.c_str());
  VkDeviceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
  info.pNext = &features.base;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  requireHostRoom(roomToOpenDevice, fmt::format("open the device {}", info_.name));
  check(vkCreateDevice(physical_, &info, nullptr, &device_),
        fmt::format("open the device {}", info_.name));
}

void Device::loadFunctions() {
  pushDescriptorSet_ = reinterpret_cast<PFN_vkCmdPushDescriptorSetKHR>(
      vkGetDeviceProcAddr(device_, "vkCmdPushDescriptorSetKHR"));
  assert(pushDescriptorSet_ != nullptr);
  if (!instance_->hasDebugUtils()) return;
  const VkInstance instance = instance_->handle();
  setObjectName_ = reinterpret_cast<PFN_vkSetDebugUtilsObjectNameEXT>(
      vkGetInstanceProcAddr(instance, "vkSetDebugUtilsObjectNameEXT"));
  beginLabel_ = reinterpret_cast<PFN_vkCmdBeginDebugUtilsLabelEXT>(
      vkGetInstanceProcAddr(instance, "vkCmdBeginDebugUtilsLabelEXT"));
  endLabel_ = reinterpret_cast<PFN_vkCmdEndDebugUtilsLabelEXT>(
      vkGetInstanceProcAddr(instance, "vkCmdEndDebugUtilsLabelEXT"));
}

void Device::loadRayFunctions() {
  const auto load = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(
        vkGetDeviceProcAddr(device_, name));
    assert(function != nullptr);
  };
  load(rays_.create, "vkCreateAccelerationStructureKHR");
  load(rays_.destroy, "vkDestroyAccelerationStructureKHR");
  load(rays_.buildSizes, "vkGetAccelerationStructureBuildSizesKHR");
  load(rays_.address, "vkGetAccelerationStructureDeviceAddressKHR");
  load(rays_.build, "vkCmdBuildAccelerationStructuresKHR");
  VkPhysicalDeviceAccelerationStructurePropertiesKHR structures{};
  structures.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_PROPERTIES_KHR;
  VkPhysicalDeviceProperties2 properties{};
  properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
  properties.pNext = &structures;
  vkGetPhysicalDeviceProperties2(physical_, &properties);
  rays_.scratchAlignment = structures.minAccelerationStructureScratchOffsetAlignment;
}

void Device::createTimeline() {
  VkSemaphoreTypeCreateInfo type{};
  type.sType = VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO;
  type.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE;
  VkSemaphoreCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
  info.pNext = &type;
  check(vkCreateSemaphore(device_, &info, nullptr, &timeline_), "create a timeline");
  setName(VK_OBJECT_TYPE_SEMAPHORE, reinterpret_cast<std::uint64_t>(timeline_), "timeline");
}

Device::~Device() {
  waitUntilIdle();
  retired_.destroyUpTo(UINT64_MAX, device_, rays_);
  vkDestroySemaphore(device_, timeline_, nullptr);
  vkDestroyDevice(device_, nullptr);
}

VkInstance Device::instance() const {
  return instance_->handle();
}

std::size_t Device::validationMessages() const {
  return instance_->messages();
}

std::uint64_t Device::submit(std::span<const VkCommandBuffer> commands) {
  assert(commands.size() <= mostBuffers);
  destroyRetired();
  std::array<VkCommandBufferSubmitInfo, mostBuffers> buffers{};
  for (std::size_t i = 0; i < commands.size(); ++i) {
    buffers[i].sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
    buffers[i].commandBuffer = commands[i];
  }
  VkSemaphoreSubmitInfo done{};
  done.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO;
  done.semaphore = timeline_;
  done.value = submitted_ + 1;
  done.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  VkSubmitInfo2 info{};
  info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
  info.commandBufferInfoCount = static_cast<std::uint32_t>(commands.size());
  info.pCommandBufferInfos = buffers.data();
  info.signalSemaphoreInfoCount = 1;
  info.pSignalSemaphoreInfos = &done;
  // What is drawn is compiled again there, for the state that it meets.
  if (info_.type == DeviceType::Software)
    requireHostRoom(roomToCompile, "submit work to the device");
  check(vkQueueSubmit2(queue_, 1, &info, VK_NULL_HANDLE), "submit work to the device");
  return ++submitted_;
}

void Device::waitFor(std::uint64_t submission) {
  assert(submission <= submitted_);
  VkSemaphoreWaitInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO;
  info.semaphoreCount = 1;
  info.pSemaphores = &timeline_;
  info.pValues = &submission;
  VkResult result = VK_TIMEOUT;  // some drivers end the longest wait early
  while (result == VK_TIMEOUT) result = vkWaitSemaphores(device_, &info, UINT64_MAX);
  check(result, "wait for the device");
  destroyRetired();
}

// A device that has too little memory to wait is asked again: what it uses must not go before.
void Device::waitUntilIdle() const {
  constexpr int attempts = 100;
  for (int i = 0; i < attempts; ++i) {
    const VkResult result = vkDeviceWaitIdle(device_);
    if (result != VK_ERROR_OUT_OF_HOST_MEMORY && result != VK_ERROR_OUT_OF_DEVICE_MEMORY) return;
  }
}

void Device::retire(VkObjectType type, std::uint64_t handle, std::size_t bytes, bool lent) {
  if (handle == 0) return;
  try {
    retired_.add(lent ? submitted_ + 1 : submitted_, type, handle, bytes);
  } catch (const std::bad_alloc&) {  // destructors come here, which must not fail
    waitUntilIdle();
    RetiredObjects::destroy(type, handle, device_, rays_);
    memoryBytes_ -= bytes;
  }
  destroyRetired();
}

void Device::destroyRetired() {
  if (retired_.empty()) return;
  std::uint64_t finished = 0;
  // A lost device cannot say; what it used goes with it.
  if (vkGetSemaphoreCounterValue(device_, timeline_, &finished) < 0) return;
  memoryBytes_ -= retired_.destroyUpTo(finished, device_, rays_);
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
    const VkResult result = vkAllocateMemory(device_, &info, nullptr, &memory);
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
    waitFor(submitted_);
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
  setObjectName_(device_, &info);  // without a name it is as good
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
