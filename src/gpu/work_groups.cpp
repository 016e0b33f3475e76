#include "gpu/work_groups.h"

#include <algorithm>
#include <bit>

namespace opaline::gpu {

namespace {

WorkGroups ofSoftware(std::uint32_t subgroupSize) {
  WorkGroups groups;
  constexpr std::uint32_t least = 8;  // shared::maxClustersOfTile
  if (subgroupSize < least) return groups;
  constexpr std::uint32_t most = 64;
  groups.invocations = std::min(subgroupSize, most);
  groups.invocationsOfTile = groups.invocations;
  // Work whose loops may end too early with eight invocations gets twice as many.
  groups.invocationsOfLongWork = std::clamp(subgroupSize, 2 * least, most);
  return groups;
}

}  // namespace

WorkGroups workGroupsOf(bool isSoftware, std::uint32_t subgroupSize,
                        const VkPhysicalDeviceLimits& limits) {
  if (isSoftware) return ofSoftware(subgroupSize);
  // As measured on an H200. Every device has at least 128.
  const auto upTo = [&](std::uint32_t best) {
    return std::bit_floor(std::min(best, limits.maxComputeWorkGroupInvocations));
  };
  WorkGroups groups;
  groups.invocationsOfLongWork = upTo(256);
  groups.invocationsOfRays = upTo(512);
  groups.invocationsOfTile = 128;
  groups.lanes = 32;
  groups.loopsEnd = false;
  groups.drawTriangles = true;
  return groups;
}

}  // namespace opaline::gpu
