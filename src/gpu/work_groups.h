#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>

namespace opaline::gpu {

/// How many invocations share a piece of work. A GPU hides the latency of reads with a hundred
/// thousand invocations; as clusters are only some thousands, each gets many. A software device
/// executes a work group's subgroups one after the other, each through the whole shader, so one
/// subgroup is best.
struct WorkGroups {
  std::uint32_t invocations = 64;            ///< shaders/lib/work_group.glsl; if less, one subgroup
  std::uint32_t invocationsOfLongWork = 64;  ///< the same with LONG_WORK
  std::uint32_t lanes = 1;                   ///< lib/lanes.glsl
  std::uint32_t invocationsOfRays = 64;  ///< for groups that send some hundred rays; at least 64
  std::uint32_t invocationsOfTile = 64;  ///< lib/work_group.glsl with TILE_WORK
  /// An invocation's loops end after 65,535 rounds in total, as on Mesa's software device.
  bool loopsEnd = true;
  bool drawTriangles = false;  ///< by lib/raster.glsl instead of rasterization hardware
};

WorkGroups workGroupsOf(bool isSoftware, std::uint32_t subgroupSize,
                        const VkPhysicalDeviceLimits& limits);

}  // namespace opaline::gpu
