#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace opaline::gpu {

constexpr std::uint32_t neededVersion = VK_API_VERSION_1_3;

/// Extensions of the device that are always needed, and those of ray queries.
constexpr std::array<const char*, 1> neededExtensions{VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME};
constexpr std::array<const char*, 3> rayExtensions{VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME,
                                                   VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME,
                                                   VK_KHR_RAY_QUERY_EXTENSION_NAME};

/// What a feature is needed for.
enum class FeatureUse { Always, RayQueries };

/// Structures for all features that Opaline uses, chained for Vulkan. Not movable: it points at
/// itself.
struct Features {
  Features();
  Features(const Features&) = delete;
  Features& operator=(const Features&) = delete;

  /// Adds the structures of ray queries, which not every device has.
  void chainRayQueries();
  /// Chains the structures of ray queries without the others.
  void chainRayQueriesAlone();

  VkPhysicalDeviceFeatures2 base{};
  VkPhysicalDeviceVulkan13Features vulkan13{};
  VkPhysicalDeviceTimelineSemaphoreFeatures timeline{};
  VkPhysicalDeviceBufferDeviceAddressFeatures addresses{};
  VkPhysicalDeviceAccelerationStructureFeaturesKHR structures{};
  VkPhysicalDeviceRayQueryFeaturesKHR rayQueries{};
};

/// Turns on all features of that use. Their structures have to be in the chain.
void turnOn(FeatureUse use, Features& features);

/// The names of features of that use that are not on in a chain, which may have structures of
/// Vulkan versions or of single extensions. Empty: all are on.
std::string featuresOff(FeatureUse use, const VkPhysicalDeviceFeatures2& chain);

/// The names of `wanted` that are not among `there`.
std::string extensionsOff(std::span<const char* const> wanted, std::span<const char* const> there);

/// A list with `more` appended, after a comma unless the list is empty.
std::string joined(const std::string& list, const std::string& more);

}  // namespace opaline::gpu
