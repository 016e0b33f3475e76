#include "gpu/device_choice.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cstring>

#include "gpu/instance.h"
#include "gpu/vulkan_result.h"
#include "opaline/error.h"

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

std::vector<VkExtensionProperties> extensionsOf(VkPhysicalDevice physical) {
  std::uint32_t count = 0;
  check(vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, nullptr),
        "list a device's extensions");
  std::vector<VkExtensionProperties> extensions(count);
  check(vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, extensions.data()),
        "list a device's extensions");
  return extensions;
}

bool hasExtension(const std::vector<VkExtensionProperties>& extensions, const char* name) {
  return std::any_of(extensions.begin(), extensions.end(), [&](const auto& extension) {
    return std::strcmp(extension.extensionName, name) == 0;
  });
}

bool canQueryRays(VkPhysicalDevice physical) {
  const std::vector<VkExtensionProperties> extensions = extensionsOf(physical);
  if (!std::all_of(rayExtensions.begin(), rayExtensions.end(),
                   [&](const char* name) { return hasExtension(extensions, name); }))
    return false;
  Features there;
  there.chainRayQueries();
  vkGetPhysicalDeviceFeatures2(physical, &there.base);
  return there.addresses.bufferDeviceAddress == VK_TRUE &&
         there.structures.accelerationStructure == VK_TRUE && there.rayQueries.rayQuery == VK_TRUE;
}

bool hasSubgroupArithmetic(VkPhysicalDevice physical) {
  VkPhysicalDeviceSubgroupProperties subgroup{};
  subgroup.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES;
  VkPhysicalDeviceProperties2 properties{};
  properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
  properties.pNext = &subgroup;
  vkGetPhysicalDeviceProperties2(physical, &properties);
  return (subgroup.supportedOperations & VK_SUBGROUP_FEATURE_ARITHMETIC_BIT) != 0 &&
         (subgroup.supportedStages & VK_SHADER_STAGE_COMPUTE_BIT) != 0;
}

VkFormatFeatureFlags featuresOf(VkPhysicalDevice physical, VkFormat format) {
  VkFormatProperties properties{};
  vkGetPhysicalDeviceFormatProperties(physical, format, &properties);
  return properties.optimalTilingFeatures;
}

/// Of the formats and uses that Vulkan leaves open to devices.
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

std::string joined(const std::string& list, const std::string& more) {
  return list.empty() || more.empty() ? list + more : list + ", " + more;
}

std::string whatIsMissing(VkPhysicalDevice physical, std::uint32_t apiVersion) {
  if (apiVersion < VK_API_VERSION_1_3) {
    return fmt::format("Vulkan 1.3 (it has {}.{})", VK_API_VERSION_MAJOR(apiVersion),
                       VK_API_VERSION_MINOR(apiVersion));
  }
  std::string missing;
  const auto need = [&](bool there, const char* name) {
    if (there) return;
    missing = joined(missing, name);
  };
  Features there;
  vkGetPhysicalDeviceFeatures2(physical, &there.base);
  need(there.base.features.imageCubeArray == VK_TRUE, "imageCubeArray");
  need(there.base.features.independentBlend == VK_TRUE, "independentBlend");
  need(there.vulkan13.dynamicRendering == VK_TRUE, "dynamicRendering");
  need(there.vulkan13.synchronization2 == VK_TRUE, "synchronization2");
  need(there.timeline.timelineSemaphore == VK_TRUE, "timelineSemaphore");
  need(there.vulkan13.maintenance4 == VK_TRUE, "maintenance4");
  need(there.vulkan13.shaderDemoteToHelperInvocation == VK_TRUE, "shaderDemoteToHelperInvocation");
  need(there.vulkan13.shaderTerminateInvocation == VK_TRUE, "shaderTerminateInvocation");
  need(hasSubgroupArithmetic(physical), "subgroup arithmetic in compute");
  need(hasExtension(extensionsOf(physical), VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME),
       VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME);
  need(findQueueFamily(physical).has_value(), "a queue for graphics and compute");
  VkPhysicalDeviceProperties properties{};
  vkGetPhysicalDeviceProperties(physical, &properties);
  const auto formats = [&](VkFormat format) { return featuresOf(physical, format); };
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
  if (index >= count) return std::nullopt;  // it may still be part of a name, as in "4090"
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

Features::Features() {
  base.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
  base.pNext = &vulkan13;
  vulkan13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
  vulkan13.pNext = &timeline;
  timeline.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_TIMELINE_SEMAPHORE_FEATURES;
}

void Features::chainRayQueries() {
  timeline.pNext = &addresses;
  addresses.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_BUFFER_DEVICE_ADDRESS_FEATURES;
  addresses.pNext = &structures;
  structures.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_FEATURES_KHR;
  structures.pNext = &rayQueries;
  rayQueries.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_QUERY_FEATURES_KHR;
}

std::string lackOfRoom(const VkPhysicalDeviceLimits& limits) {
  const std::uint32_t buffers = limits.maxPerStageDescriptorStorageBuffers;
  if (buffers >= storageBuffersOfStage) return {};
  return fmt::format("{} storage buffers in one shader (it has {})", storageBuffersOfStage,
                     buffers);
}

std::string lackOfFormats(const std::function<VkFormatFeatureFlags(VkFormat)>& featuresOf) {
  std::string lack;
  for (const FormatNeed& need : formatNeeds)
    if ((featuresOf(need.format) & need.features) != need.features) lack = joined(lack, need.name);
  return lack;
}

std::optional<std::uint32_t> findQueueFamily(VkPhysicalDevice physical) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
  constexpr VkQueueFlags needed = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
  for (std::uint32_t i = 0; i < count; ++i) {
    if ((families[i].queueFlags & needed) == needed) return i;
  }
  return std::nullopt;
}

DeviceInfo describe(VkPhysicalDevice physical, std::uint32_t index) {
  VkPhysicalDeviceProperties properties{};
  vkGetPhysicalDeviceProperties(physical, &properties);
  DeviceInfo info;
  info.index = index;
  info.name = properties.deviceName;
  info.type = typeOf(properties.deviceType);
  info.missing = whatIsMissing(physical, properties.apiVersion);
  info.rayQueries = info.missing.empty() && canQueryRays(physical);
  info.driver = fmt::format("version {}", properties.driverVersion);
  if (properties.apiVersion >= VK_API_VERSION_1_2) {
    VkPhysicalDeviceDriverProperties driver{};
    driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
    VkPhysicalDeviceProperties2 all{};
    all.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    all.pNext = &driver;
    vkGetPhysicalDeviceProperties2(physical, &all);
    info.driver = fmt::format("{} {}", driver.driverName, driver.driverInfo);
  }
  return info;
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
  if (!device.missing.empty()) {
    throw Error(fmt::format(
        "the Vulkan device {} cannot be used, because it lacks {}; update its driver or choose "
        "another device",
        device.name, device.missing));
  }
  return *chosen;
}

}  // namespace opaline::gpu
