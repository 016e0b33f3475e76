#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>

namespace opaline::gpu {

/// Into how many invocations work is divided that several may share. A GPU hides how long a read
/// takes by having a hundred thousand at hand, where clusters are some thousands: it gets many for
/// each. A software device executes the subgroups of a work group one after the other, all of the
/// shader for each, so that one is best.
struct WorkGroups {
  std::uint32_t invocations = 64;            ///< shaders/lib/work_group.glsl; if less, one subgroup
  std::uint32_t invocationsOfLongWork = 64;  ///< the same with LONG_WORK
  std::uint32_t lanes = 1;                   ///< lib/lanes.glsl
  std::uint32_t invocationsOfRays = 64;      ///< of groups that send some hundred; 64 at least
  std::uint32_t invocationsOfTile = 64;      ///< lib/work_group.glsl with TILE_WORK
  bool drawTriangles = false;                ///< lib/raster.glsl, not hardware that draws
};

WorkGroups workGroupsOf(bool isSoftware, std::uint32_t subgroupSize,
                        const VkPhysicalDeviceLimits& limits);

}  // namespace opaline::gpu
