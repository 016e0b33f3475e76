#pragma once

#include <cstdint>
#include <vector>

#include "core/rest_surface.h"
#include "passes/products.h"
#include "surfels/clusters.h"
#include "surfels/surfels.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Rays by which a cluster finds what it sees.
constexpr std::uint32_t raysOutwards = 48;

/// The roles of a scene's parts in boundary transport.
struct BodyKinds {
  std::vector<bool> triangleHasInside;  ///< of all objects
  std::vector<bool> objectIsOpaque;
  std::uint32_t firstLining = ~0U;  ///< first triangle of the linings, which come last
};

/// The places at which boundary transport is solved, as far as they depend on the rest pose alone,
/// and room for what ClusterPass and the passes after it find in each frame.
Clusters makeClusters(gpu::Device& device, const surfels::ClusterDivision& made,
                      const core::RestSurface& surface, const surfels::SurfelDivision& surfels,
                      const BodyKinds& kinds);

}  // namespace opaline::passes
