#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <type_traits>

#include "gpu/device.h"
#include "gpu/device_choice.h"
#include "gpu/host_room.h"
#include "gpu/instance.h"
#include "gpu/vulkan_needs.h"
#include "gpu/vulkan_result.h"
#include "opaline/error.h"

namespace opaline::gpu {

namespace {

std::vector<DeviceInfo> describeAll(const InstanceFunctions& vk,
                                    const std::vector<VkPhysicalDevice>& devices) {
  std::vector<DeviceInfo> infos;
  infos.reserve(devices.size());
  for (const VkPhysicalDevice device : devices) {
    infos.push_back(describe(vk, device, static_cast<std::uint32_t>(infos.size())));
  }
  return infos;
}

// A software device has no hardware for rays. Compute shaders are faster there, as they are
// specialised.
bool usesRayQueries(const DeviceInfo& info, std::optional<bool> wanted) {
  if (wanted == true && !info.rayQueries) {
    throw UsageError(
        fmt::format("the Vulkan device {} has no ray queries (VK_KHR_ray_query); update its driver "
                    "or leave rays to compute shaders",
                    info.name));
  }
  return wanted.value_or(info.rayQueries && info.type != DeviceType::Software);
}

// Throws UsageError for errors in a given device that can be seen without calling Vulkan.
void requireWhole(const DeviceOptions& options) {
  const GivenVulkan& given = *options.given;
  const auto refuse = [](const std::string& why) { throw UsageError("GivenVulkan: " + why); };
  if (given.instance == VK_NULL_HANDLE || given.physicalDevice == VK_NULL_HANDLE ||
      given.device == VK_NULL_HANDLE || given.queue == VK_NULL_HANDLE)
    refuse("instance, physicalDevice, device and queue are needed");
  if (given.enabledFeatures == nullptr)
    refuse("enabledFeatures is needed, with the features that the device was made with");
  if (static_cast<bool>(given.lockQueue) != static_cast<bool>(given.unlockQueue))
    refuse("lockQueue and unlockQueue go together");
  if (!options.selector.empty() || options.validation || !options.instanceExtensions.empty() ||
      !options.deviceExtensions.empty())
    refuse(
        "device, validation and extensions of RendererOptions are for devices of the renderer's "
        "own");
  if (std::any_of(given.enabledExtensions.begin(), given.enabledExtensions.end(),
                  [](const char* name) { return name == nullptr; }))
    refuse("enabledExtensions has a name that is null");
  const std::string off = joined(extensionsOff(neededExtensions, given.enabledExtensions),
                                 featuresOff(FeatureUse::Always, *given.enabledFeatures));
  if (!off.empty()) refuse("the device was made without " + off);
}

bool canQueryRays(const GivenVulkan& given) {
  return extensionsOff(rayExtensions, given.enabledExtensions).empty() &&
         featuresOff(FeatureUse::RayQueries, *given.enabledFeatures).empty();
}

}  // namespace

std::vector<DeviceInfo> Device::list() {
  // Without memory for drivers, the loader would skip them as if there were none.
  requireHostRoom(roomToOpenDevice, "list the devices");
  try {
    const Instance instance;
    return describeAll(loadInstanceFunctions(vkGetInstanceProcAddr, instance.handle()),
                       instance.physicalDevices());
  } catch (const Error& error) {
    if (std::string(error.what()) == noDeviceMessage) return {};
    throw;
  }
}

Device::Device(const DeviceOptions& options) : mostMemoryBytes_(options.mostMemoryBytes) {
  try {
    if (options.given != nullptr)
      takeGiven(options);
    else
      openOwn(options);
    setName(VK_OBJECT_TYPE_QUEUE, reinterpret_cast<std::uint64_t>(queue_), "queue");
    createTimeline();
    createPipelineCache(options.pipelineCache);
  } catch (...) {
    destroyObjects();
    throw;
  }
}

void Device::openOwn(const DeviceOptions& options) {
  ownInstance_ =
      std::make_unique<Instance>(options.validation, options.log, options.instanceExtensions);
  instance_ = ownInstance_->handle();
  ofInstance_ = loadInstanceFunctions(vkGetInstanceProcAddr, instance_);
  const std::vector<VkPhysicalDevice> devices = ownInstance_->physicalDevices();
  const std::vector<DeviceInfo> infos = describeAll(ofInstance_, devices);
  const std::size_t chosen = choose(infos, options.selector);
  info_ = infos[chosen];
  physical_ = devices[chosen];
  queueFamily_ = findQueueFamily(ofInstance_, physical_).value();
  readProperties();
  const bool rayQueries = usesRayQueries(info_, options.rayQueries);
  createDevice(options.deviceExtensions, rayQueries);
  loadFunctions(vkGetInstanceProcAddr, rayQueries);
  vk_.vkGetDeviceQueue(device_, queueFamily_, 0, &queue_);
}

void Device::takeGiven(const DeviceOptions& options) {
  requireWhole(options);
  const GivenVulkan& given = *options.given;
  const PFN_vkGetInstanceProcAddr load =
      given.getInstanceProcAddr != nullptr ? given.getInstanceProcAddr : vkGetInstanceProcAddr;
  lockQueue_ = given.lockQueue;
  unlockQueue_ = given.unlockQueue;
  instance_ = given.instance;
  physical_ = given.physicalDevice;
  device_ = given.device;
  queueFamily_ = given.queueFamily;
  queue_ = given.queue;
  ofInstance_ = loadInstanceFunctions(load, instance_);
  info_ = describe(ofInstance_, physical_, 0);
  if (!info_.missing.empty()) throw Error(unfitMessage(info_));
  if (!isQueueFamilyFit(ofInstance_, physical_, queueFamily_))
    throw UsageError("GivenVulkan: the queue's family does not do both graphics and compute");
  info_.rayQueries = info_.rayQueries && canQueryRays(given);
  readProperties();
  loadFunctions(load, usesRayQueries(info_, options.rayQueries));
}

void Device::readProperties() {
  VkPhysicalDeviceMaintenance4Properties buffers{};
  buffers.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_4_PROPERTIES;
  VkPhysicalDeviceMaintenance3Properties maintenance{};
  maintenance.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES;
  maintenance.pNext = &buffers;
  VkPhysicalDeviceSubgroupProperties subgroups{};
  subgroups.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES;
  buffers.pNext = &subgroups;
  VkPhysicalDeviceProperties2 properties{};
  properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
  properties.pNext = &maintenance;
  ofInstance_.vkGetPhysicalDeviceProperties2(physical_, &properties);
  properties_ = properties.properties;
  const bool isSoftware = info_.type == DeviceType::Software;
  workGroups_ = workGroupsOf(isSoftware, subgroups.subgroupSize, limits());
  if (!isSoftware && hasRoomForTexels(limits())) shaderVariant_ = ShaderVariant::Storage;
  largestBufferBytes_ = buffers.maxBufferSize;
  largestAllocationBytes_ = maintenance.maxMemoryAllocationSize;
  ofInstance_.vkGetPhysicalDeviceMemoryProperties(physical_, &memoryProperties_);
}

void Device::createDevice(const std::vector<std::string>& wanted, bool rayQueries) {
  Features features;
  turnOn(FeatureUse::Always, features);
  if (rayQueries) {
    features.chainRayQueries();
    turnOn(FeatureUse::RayQueries, features);
  }
  const float priority = 1.0F;
  VkDeviceQueueCreateInfo queue{};
  queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
  queue.queueFamilyIndex = queueFamily_;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  std::vector<const char*> extensions(neededExtensions.begin(), neededExtensions.end());
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
  check(ofInstance_.vkCreateDevice(physical_, &info, nullptr, &device_),
        fmt::format("open the device {}", info_.name));
}

void Device::loadFunctions(PFN_vkGetInstanceProcAddr load, bool rayQueries) {
  vk_ = loadDeviceFunctions(ofInstance_, device_);
  if (rayQueries) {
    loadRayFunctions();
    shaderVariant_ = ShaderVariant::RayQueries;
  }
  // Null if the instance was made without VK_EXT_debug_utils.
  setObjectName_ = reinterpret_cast<PFN_vkSetDebugUtilsObjectNameEXT>(
      load(instance_, "vkSetDebugUtilsObjectNameEXT"));
  beginLabel_ = reinterpret_cast<PFN_vkCmdBeginDebugUtilsLabelEXT>(
      load(instance_, "vkCmdBeginDebugUtilsLabelEXT"));
  endLabel_ = reinterpret_cast<PFN_vkCmdEndDebugUtilsLabelEXT>(
      load(instance_, "vkCmdEndDebugUtilsLabelEXT"));
}

void Device::loadRayFunctions() {
  const auto load = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(
        ofInstance_.vkGetDeviceProcAddr(device_, name));
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
  ofInstance_.vkGetPhysicalDeviceProperties2(physical_, &properties);
  rays_.scratchAlignment = structures.minAccelerationStructureScratchOffsetAlignment;
}

void Device::createTimeline() {
  VkSemaphoreTypeCreateInfo type{};
  type.sType = VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO;
  type.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE;
  VkSemaphoreCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
  info.pNext = &type;
  check(vk_.vkCreateSemaphore(device_, &info, nullptr, &timeline_), "create a timeline");
  setName(VK_OBJECT_TYPE_SEMAPHORE, reinterpret_cast<std::uint64_t>(timeline_), "timeline");
}

}  // namespace opaline::gpu
