#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "opaline/log.h"
#include "opaline/medium.h"
#include "opaline/scene.h"
#include "renderer/scene/device_room.h"
#include "renderer/scene/insides.h"
#include "scene/mesh/merged_mesh.h"
#include "surfels/clusters.h"
#include "surfels/surfels.h"

namespace opaline {

/// How finely a scene's surface is to be divided for its media.
struct DivisionOrder {
  std::vector<double> spacingOfBodyMm;                ///< of surfels
  std::vector<surfels::ClusterOrder> clustersOfBody;  ///< empty without clusters
  std::size_t maxSurfels = 0;
  std::size_t maxClusters = 0;

  bool operator==(const DivisionOrder&) const = default;
};

/// The order for the finest medium of each body. It has clusters, and reads `insides`, only if
/// `maxClusters` is set.
DivisionOrder divisionFor(const Scene& scene, const scene::MergedMesh& merged,
                          const Insides& insides, std::size_t maxSurfels,
                          std::optional<std::size_t> maxClusters);

/// A surface divided into surfels and, if ordered, clusters of them; on the host.
struct Division {
  DivisionOrder order;
  surfels::SurfelDivision surfels;
  std::optional<surfels::ClusterDivision> clusters;
};

/// May be called from any thread. Takes tenths of a second for 100,000 triangles.
Division divide(const scene::MergedMesh& merged, const DivisionOrder& order,
                const Within& within = {});

/// Logs how far the budgets of surfels and clusters fall short, and whether larger ones would help.
void noteCoarseness(const Division& division, const DeviceRoom& room, const LogCallback& log);

}  // namespace opaline
