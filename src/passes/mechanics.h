#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/command_list.h"
#include "gpu/device.h"
#include "passes/products.h"

/// Helpers that passes are made from.
namespace opaline::passes {

/// Usage of buffers that shaders write, and read as storage or texels.
constexpr VkBufferUsageFlags roomUsage =
    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;

/// Room for `count` of T that shaders write, and read as storage or texels; for one texel at least.
template <typename T>
gpu::Buffer makeRoom(gpu::Device& device, std::string name, std::size_t count) {
  constexpr std::size_t texel = 4 * sizeof(float);
  return {
      device,
      {.name = std::move(name), .bytes = std::max(count * sizeof(T), texel), .usage = roomUsage}};
}

/// Bytes of the largest buffer that shaders may read as storage and as texels of four floats.
inline std::size_t mostBytes(const VkPhysicalDeviceLimits& limits) {
  return std::min(std::size_t{limits.maxStorageBufferRange},
                  limits.maxTexelBufferElements * (4 * sizeof(float)));
}

/// The binding of the rays' hierarchy for shaders with lib/rays.glsl.
inline gpu::TexelsOrRays rays(RayHierarchy& hierarchy) {
  if (hierarchy.structure) return hierarchy.structure;
  return hierarchy.boxes;
}

/// Invocations of a work group of shaders with lib/linear.glsl.
constexpr std::uint32_t groupSize = 64;

/// An upper bound of the loop rounds of an invocation that walks a tree or sends a ray through one;
/// usual are some hundreds.
constexpr std::uint32_t roundsOfWalk = 1024;

}  // namespace opaline::passes
