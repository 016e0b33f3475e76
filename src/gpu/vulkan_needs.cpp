#include "gpu/vulkan_needs.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstring>

#include "opaline/vulkan.h"

namespace opaline {

namespace gpu {

namespace {

/// The place of a feature in a structure.
struct FeaturePlace {
  VkStructureType structure;
  std::size_t offset;
};

/// One feature, and the structures that can turn it on.
struct FeatureNeed {
  const char* name;
  FeatureUse use;
  std::array<FeaturePlace, 2> places;
};

constexpr FeaturePlace ofVulkan10(std::size_t offset) {
  return {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2,
          offsetof(VkPhysicalDeviceFeatures2, features) + offset};
}
constexpr FeaturePlace ofVulkan12(std::size_t offset) {
  return {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES, offset};
}
constexpr FeaturePlace ofVulkan13(std::size_t offset) {
  return {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES, offset};
}
constexpr FeaturePlace nowhere{VK_STRUCTURE_TYPE_MAX_ENUM, 0};

constexpr FeatureNeed featureNeeds[] = {
    {"imageCubeArray",
     FeatureUse::Always,
     {{ofVulkan10(offsetof(VkPhysicalDeviceFeatures, imageCubeArray)), nowhere}}},
    {"independentBlend",
     FeatureUse::Always,
     {{ofVulkan10(offsetof(VkPhysicalDeviceFeatures, independentBlend)), nowhere}}},
    {"timelineSemaphore",
     FeatureUse::Always,
     {{ofVulkan12(offsetof(VkPhysicalDeviceVulkan12Features, timelineSemaphore)),
       {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_TIMELINE_SEMAPHORE_FEATURES,
        offsetof(VkPhysicalDeviceTimelineSemaphoreFeatures, timelineSemaphore)}}}},
    {"dynamicRendering",
     FeatureUse::Always,
     {{ofVulkan13(offsetof(VkPhysicalDeviceVulkan13Features, dynamicRendering)),
       {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DYNAMIC_RENDERING_FEATURES,
        offsetof(VkPhysicalDeviceDynamicRenderingFeatures, dynamicRendering)}}}},
    {"synchronization2",
     FeatureUse::Always,
     {{ofVulkan13(offsetof(VkPhysicalDeviceVulkan13Features, synchronization2)),
       {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SYNCHRONIZATION_2_FEATURES,
        offsetof(VkPhysicalDeviceSynchronization2Features, synchronization2)}}}},
    // Required by glslc's SPIR-V 1.6 for work-group sizes by specialization constant and for
    // `discard`.
    {"maintenance4",
     FeatureUse::Always,
     {{ofVulkan13(offsetof(VkPhysicalDeviceVulkan13Features, maintenance4)),
       {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_4_FEATURES,
        offsetof(VkPhysicalDeviceMaintenance4Features, maintenance4)}}}},
    {"shaderDemoteToHelperInvocation",
     FeatureUse::Always,
     {{ofVulkan13(offsetof(VkPhysicalDeviceVulkan13Features, shaderDemoteToHelperInvocation)),
       {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SHADER_DEMOTE_TO_HELPER_INVOCATION_FEATURES,
        offsetof(VkPhysicalDeviceShaderDemoteToHelperInvocationFeatures,
                 shaderDemoteToHelperInvocation)}}}},
    {"shaderTerminateInvocation",
     FeatureUse::Always,
     {{ofVulkan13(offsetof(VkPhysicalDeviceVulkan13Features, shaderTerminateInvocation)),
       {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SHADER_TERMINATE_INVOCATION_FEATURES,
        offsetof(VkPhysicalDeviceShaderTerminateInvocationFeatures, shaderTerminateInvocation)}}}},
    {"bufferDeviceAddress",
     FeatureUse::RayQueries,
     {{ofVulkan12(offsetof(VkPhysicalDeviceVulkan12Features, bufferDeviceAddress)),
       {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_BUFFER_DEVICE_ADDRESS_FEATURES,
        offsetof(VkPhysicalDeviceBufferDeviceAddressFeatures, bufferDeviceAddress)}}}},
    {"accelerationStructure",
     FeatureUse::RayQueries,
     {{{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_FEATURES_KHR,
        offsetof(VkPhysicalDeviceAccelerationStructureFeaturesKHR, accelerationStructure)},
       nowhere}}},
    {"rayQuery",
     FeatureUse::RayQueries,
     {{{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_QUERY_FEATURES_KHR,
        offsetof(VkPhysicalDeviceRayQueryFeaturesKHR, rayQuery)},
       nowhere}}},
};

// The place of a feature in a chain; null if the chain has no structure for it.
const VkBool32* placeIn(const void* chain, const FeatureNeed& need) {
  for (const auto* structure = static_cast<const VkBaseInStructure*>(chain); structure != nullptr;
       structure = structure->pNext)
    for (const FeaturePlace& place : need.places)
      if (place.structure == structure->sType)
        return reinterpret_cast<const VkBool32*>(reinterpret_cast<const std::byte*>(structure) +
                                                 place.offset);
  return nullptr;
}

// The needs, as data that lives as long as the process.
struct NeedsOfProcess {
  NeedsOfProcess() {
    turnOn(FeatureUse::Always, required);
    optional.chainRayQueriesAlone();
    turnOn(FeatureUse::RayQueries, optional);
    needs = {neededVersion, neededExtensions, rayExtensions, &required.base, &optional.base};
  }
  Features required;
  Features optional;
  VulkanNeeds needs;
};

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

void Features::chainRayQueriesAlone() {
  chainRayQueries();
  base.pNext = &addresses;
}

void turnOn(FeatureUse use, Features& features) {
  for (const FeatureNeed& need : featureNeeds) {
    if (need.use != use) continue;
    const VkBool32* place = placeIn(&features.base, need);
    assert(place != nullptr);
    *const_cast<VkBool32*>(place) = VK_TRUE;
  }
}

std::string featuresOff(FeatureUse use, const VkPhysicalDeviceFeatures2& chain) {
  std::string off;
  for (const FeatureNeed& need : featureNeeds) {
    if (need.use != use) continue;
    const VkBool32* place = placeIn(&chain, need);
    if (place == nullptr || *place != VK_TRUE) off = joined(off, need.name);
  }
  return off;
}

std::string extensionsOff(std::span<const char* const> wanted, std::span<const char* const> there) {
  std::string off;
  for (const char* name : wanted) {
    const auto same = [&](const char* other) { return std::strcmp(name, other) == 0; };
    if (std::none_of(there.begin(), there.end(), same)) off = joined(off, name);
  }
  return off;
}

std::string joined(const std::string& list, const std::string& more) {
  return list.empty() || more.empty() ? list + more : list + ", " + more;
}

}  // namespace gpu

const VulkanNeeds& vulkanNeeds() {
  static const gpu::NeedsOfProcess ofProcess;
  return ofProcess.needs;
}

}  // namespace opaline
