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

/// Prepares the surface of a frame for rays of shaders: the pieces of surfels and, around them,
/// boxes on the surfels' tree or the device's refitted acceleration structure. See lib/rays.glsl.
class RayPass {
 public:
  explicit RayPass(gpu::Device& device);

  /// For set-up, not for frames. Makes only boxes, for searches of places.
  static RayHierarchy makeBoxes(gpu::Device& device, const Surfels& surfels);
  /// Makes a hierarchy for rays, with an acceleration structure of the rest pose if the device has
  /// ray queries. What was divided together is one body, named after its first object if that is
  /// given.
  static RayHierarchy makeHierarchy(gpu::Device& device, const Surfels& surfels,
                                    const surfels::SurfelDivision& made,
                                    const core::RestSurface& rest,
                                    std::span<const std::uint32_t> firstObjectOfBody = {});

  /// Records pieces and the acceleration structure or, without one, boxes.
  void record(gpu::CommandList& commands, DeformedMesh& mesh, Surfels& surfels,
              RayHierarchy& hierarchy) const;
  /// Records the boxes that record() left out for this pose.
  void recordBoxes(gpu::CommandList& commands, Surfels& surfels, RayHierarchy& hierarchy) const;

 private:
  void recordPieces(gpu::CommandList& commands, DeformedMesh& mesh, Surfels& surfels,
                    RayHierarchy& hierarchy) const;
  void recordNodes(gpu::CommandList& commands, Surfels& surfels, RayHierarchy& hierarchy) const;

  gpu::Compute<shaders::BoundaryRayLeaves> leaves_;
  gpu::Compute<shaders::BoundaryRayNodes> nodes_;
};

}  // namespace opaline::passes
