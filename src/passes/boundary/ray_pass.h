#pragma once

#include <cstdint>
#include <span>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/boundary/ray_leaves.comp.h"
#include "shaders/boundary/ray_nodes.comp.h"
#include "surfels/surfels.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Makes the surface as it lies in this frame something that shaders send rays through: the pieces
/// of surfels where they are and, around them, boxes on the surfels' tree or the device's own
/// acceleration structure, refitted. See lib/rays.glsl.
class RayPass {
 public:
  explicit RayPass(gpu::Device& device);

  /// For set-up, not for frames. Boxes alone, for whoever looks for places.
  static RayHierarchy makeBoxes(gpu::Device& device, const Surfels& surfels);
  /// For rays: with an acceleration structure of the rest pose where the device has ray queries.
  /// What was divided together is one body, with the name of its first object if that is given.
  static RayHierarchy makeHierarchy(gpu::Device& device, const Surfels& surfels,
                                    const surfels::SurfelDivision& made,
                                    const core::RestSurface& rest,
                                    std::span<const std::uint32_t> firstObjectOfBody = {});

  /// Boxes only where there is no acceleration structure.
  void record(gpu::CommandList& commands, DeformedMesh& mesh, Surfels& surfels,
              RayHierarchy& hierarchy) const;
  /// The boxes that `record` of this pose has left out.
  void recordBoxes(gpu::CommandList& commands, Surfels& surfels, RayHierarchy& hierarchy) const;

 private:
  void recordPieces(gpu::CommandList& commands, DeformedMesh& mesh, Surfels& surfels,
                    RayHierarchy& hierarchy) const;
  void recordNodes(gpu::CommandList& commands, Surfels& surfels, RayHierarchy& hierarchy) const;

  gpu::Compute<shaders::BoundaryRayLeaves> leaves_;
  gpu::Compute<shaders::BoundaryRayNodes> nodes_;
};

}  // namespace opaline::passes
