#include "gpu/device_choice.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <span>

#include "gpu/instance.h"
#include "gpu/vulkan_functions.h"
#include "gpu/vulkan_needs.h"
#include "gpu/vulkan_result.h"
#include "opaline/error.h"
#include "opaline/vulkan.h"

namespace opaline::gpu {

namespace {

DeviceType typeOf(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return DeviceType::Discrete;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return DeviceType::Integrated;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return DeviceType::Virtual;
    default:
      return DeviceType::Software;
  }
}

/// A physical device and the functions that query it.
struct Asked {
  const InstanceFunctions& vk;
  VkPhysicalDevice physical;

  std::vector<VkExtensionProperties> extensions() const {
    std::uint32_t count = 0;
    check(vk.vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, nullptr),
          "list a device's extensions");
    std::vector<VkExtensionProperties> extensions(count);
    check(vk.vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, extensions.data()),
          "list a device's extensions");
    return extensions;
  }

  std::string lackOfExtensions(std::span<const char* const> wanted) const {
    const std::vector<VkExtensionProperties> there = extensions();
    std::vector<const char*> names;
    names.reserve(there.size());
    for (const VkExtensionProperties& extension : there) names.push_back(extension.extensionName);
    return extensionsOff(wanted, names);
  }

  std::string lackOfFeatures(FeatureUse use) const {
    Features there;
    if (use == FeatureUse::RayQueries) there.chainRayQueries();
    vk.vkGetPhysicalDeviceFeatures2(physical, &there.base);
    return featuresOff(use, there.base);
  }

  bool canQueryRays() const {
    return lackOfExtensions(rayExtensions).empty() &&
           lackOfFeatures(FeatureUse::RayQueries).empty() && hasRoomForTexels(properties().limits);
  }

  bool hasSubgroupArithmetic() const {
    VkPhysicalDeviceSubgroupProperties subgroup{};
    subgroup.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &subgroup;
    vk.vkGetPhysicalDeviceProperties2(physical, &properties);
    constexpr std::uint32_t least = 4;  // lib/tile_sum.glsl
    return subgroup.subgroupSize >= least &&
           (subgroup.supportedOperations & VK_SUBGROUP_FEATURE_ARITHMETIC_BIT) != 0 &&
           (subgroup.supportedStages & VK_SHADER_STAGE_COMPUTE_BIT) != 0;
  }

  VkFormatFeatureFlags featuresOf(VkFormat format) const {
    VkFormatProperties properties{};
    vk.vkGetPhysicalDeviceFormatProperties(physical, format, &properties);
    return properties.optimalTilingFeatures;
  }

  VkPhysicalDeviceProperties properties() const {
    VkPhysicalDeviceProperties properties{};
    vk.vkGetPhysicalDeviceProperties(physical, &properties);
    return properties;
  }
};

/// A format and its uses that Vulkan does not guarantee.
struct FormatNeed {
  VkFormat format;
  VkFormatFeatureFlags features;
  const char* name;
};

constexpr FormatNeed formatNeeds[] = {
    {VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT,
     "linear filtering of images of 32-bit floats"},
    {VK_FORMAT_D32_SFLOAT,
     VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT,
     "depth maps of 32-bit floats"},
};

std::string lackOf(const Asked& device) {
  const VkPhysicalDeviceProperties properties = device.properties();
  if (properties.apiVersion < neededVersion) {
    return fmt::format("Vulkan {}.{} (it has {}.{})", VK_API_VERSION_MAJOR(neededVersion),
                       VK_API_VERSION_MINOR(neededVersion),
                       VK_API_VERSION_MAJOR(properties.apiVersion),
                       VK_API_VERSION_MINOR(properties.apiVersion));
  }
  std::string missing = device.lackOfFeatures(FeatureUse::Always);
  if (!device.hasSubgroupArithmetic()) missing = joined(missing, "subgroup arithmetic in compute");
  missing = joined(missing, device.lackOfExtensions(neededExtensions));
  if (!findQueueFamily(device.vk, device.physical))
    missing = joined(missing, "a queue for graphics and compute");
  const auto formats = [&](VkFormat format) { return device.featuresOf(format); };
  return joined(joined(missing, lackOfRoom(properties.limits)), lackOfFormats(formats));
}

std::string lowered(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::optional<std::size_t> asIndex(const std::string& selector, std::size_t count) {
  if (selector.size() > 6 || !std::all_of(selector.begin(), selector.end(),
                                          [](unsigned char c) { return std::isdigit(c) != 0; })) {
    return std::nullopt;
  }
  const std::size_t index = std::stoul(selector);
  if (index >= count) return std::nullopt;  // the number may still be part of a name, as in "4090"
  return index;
}

bool isBetter(const DeviceInfo& a, const DeviceInfo& b) {
  if (a.missing.empty() != b.missing.empty()) return a.missing.empty();
  return a.type < b.type;
}

std::string namesOf(const std::vector<DeviceInfo>& devices) {
  std::string names;
  for (const DeviceInfo& device : devices) {
    if (!names.empty()) names += ", ";
    names += fmt::format("{} ({})", device.index, device.name);
  }
  return names;
}

}  // namespace

std::string lackOfRoom(const VkPhysicalDeviceLimits& limits) {
  const std::uint32_t buffers = limits.maxPerStageDescriptorStorageBuffers;
  if (buffers >= storageBuffersOfStage) return {};
  return fmt::format("{} storage buffers in one shader (it has {})", storageBuffersOfStage,
                     buffers);
}

bool hasRoomForTexels(const VkPhysicalDeviceLimits& limits) {
  return limits.maxPerStageDescriptorStorageBuffers >= storageBuffersForTexels;
}

std::string lackOfFormats(const std::function<VkFormatFeatureFlags(VkFormat)>& featuresOf) {
  std::string lack;
  for (const FormatNeed& need : formatNeeds)
    if ((featuresOf(need.format) & need.features) != need.features) lack = joined(lack, need.name);
  return lack;
}

bool isQueueFamilyFit(const InstanceFunctions& vk, VkPhysicalDevice physical,
                      std::uint32_t family) {
  std::uint32_t count = 0;
  vk.vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vk.vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
  constexpr VkQueueFlags needed = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
  return family < count && (families[family].queueFlags & needed) == needed;
}

std::optional<std::uint32_t> findQueueFamily(const InstanceFunctions& vk,
                                             VkPhysicalDevice physical) {
  std::uint32_t count = 0;
  vk.vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
  for (std::uint32_t i = 0; i < count; ++i)
    if (isQueueFamilyFit(vk, physical, i)) return i;
  return std::nullopt;
}

DeviceInfo describe(const InstanceFunctions& vk, VkPhysicalDevice physical, std::uint32_t index) {
  const Asked device{vk, physical};
  const VkPhysicalDeviceProperties properties = device.properties();
  DeviceInfo info;
  info.index = index;
  info.name = properties.deviceName;
  info.type = typeOf(properties.deviceType);
  info.missing = lackOf(device);
  info.rayQueries = info.missing.empty() && device.canQueryRays();
  info.driver = fmt::format("version {}", properties.driverVersion);
  if (properties.apiVersion >= VK_API_VERSION_1_2) {
    VkPhysicalDeviceDriverProperties driver{};
    driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
    VkPhysicalDeviceProperties2 all{};
    all.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    all.pNext = &driver;
    vk.vkGetPhysicalDeviceProperties2(physical, &all);
    info.driver = fmt::format("{} {}", driver.driverName, driver.driverInfo);
  }
  return info;
}

std::string unfitMessage(const DeviceInfo& device) {
  return fmt::format(
      "the Vulkan device {} cannot be used, because it lacks {}; update its driver or choose "
      "another device",
      device.name, device.missing);
}

std::size_t choose(const std::vector<DeviceInfo>& devices, const std::string& selector) {
  if (devices.empty()) throw Error(noDeviceMessage);
  std::optional<std::size_t> chosen;
  if (!selector.empty()) chosen = asIndex(selector, devices.size());
  if (!chosen) {
    for (std::size_t i = 0; i < devices.size(); ++i) {
      if (lowered(devices[i].name).find(lowered(selector)) == std::string::npos) continue;
      if (!chosen || isBetter(devices[i], devices[*chosen])) chosen = i;
    }
  }
  if (!chosen) {
    throw UsageError(
        fmt::format("no Vulkan device fits \"{}\"; there are: {}", selector, namesOf(devices)));
  }
  const DeviceInfo& device = devices[*chosen];
  if (!device.missing.empty()) throw Error(unfitMessage(device));
  return *chosen;
}

}  // namespace opaline::gpu

namespace opaline {

std::string whatIsMissing(VkInstance instance, VkPhysicalDevice physicalDevice) {
  if (instance == VK_NULL_HANDLE || physicalDevice == VK_NULL_HANDLE)
    throw UsageError("whatIsMissing() needs an instance and a physical device");
  const gpu::InstanceFunctions vk = gpu::loadInstanceFunctions(vkGetInstanceProcAddr, instance);
  const gpu::DeviceInfo info = gpu::describe(vk, physicalDevice, 0);
  return info.missing.empty() ? std::string() : gpu::unfitMessage(info);
}

}  // namespace opaline
