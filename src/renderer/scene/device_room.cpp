#include "renderer/scene/device_room.h"

#include <fmt/format.h>

#include <algorithm>

#include "opaline/error.h"
#include "passes/boundary/clusters.h"
#include "passes/mechanics.h"
#include "shaders/shared/boundary.h"
#include "shaders/shared/frame.h"
#include "shaders/shared/rays.h"
#include "shaders/shared/surfels.h"

namespace opaline {

namespace {

// Bytes per piece of the largest buffer of pieces.
constexpr std::size_t bytesOfPiece =
    std::max(sizeof(shared::SurfelPiece), sizeof(shared::RayPiece));
constexpr std::size_t bytesOfSurfel =
    std::max(shared::sourcesPerSurfel * sizeof(shared::Source), bytesOfPiece);
constexpr std::size_t bytesBehind =
    sizeof(shared::MeetingBehind) * shared::meetingsBehind * std::size_t{passes::raysOutwards};
constexpr std::size_t bytesOfCluster = std::max(
    {(shared::maxLights + 1) * sizeof(shared::Entry), shared::maxPoints * sizeof(shared::BeamPoint),
     (shared::maxSolverSteps + 1) * sizeof(shared::vec4),
     shared::leastRoomOfList * sizeof(std::uint32_t) / shared::maxClustersOfTile, bytesBehind});

}  // namespace

DeviceRoom roomOf(const VkPhysicalDeviceLimits& limits) {
  const std::size_t bytes = passes::mostBytes(limits);
  return {bytes / bytesOfPiece, bytes / bytesOfSurfel, bytes / bytesOfCluster};
}

void requireRoom(std::size_t triangles, const DeviceRoom& room, const std::string& device) {
  if (triangles <= room.triangles) return;
  throw Error(
      fmt::format("the scene has {} triangles, but {} has room for no more than {}; simplify the "
                  "meshes or choose another device",
                  triangles, device, room.triangles));
}

}  // namespace opaline
