#pragma once

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Makes the surface as it lies in this frame something that shaders send rays through: the pieces
/// of surfels where they are, and boxes around them on the surfels' tree. See lib/rays.glsl.
class RayPass {
 public:
  explicit RayPass(gpu::Device& device);

  /// For set-up, not for frames.
  static RayHierarchy makeHierarchy(gpu::Device& device, const Surfels& surfels);

  void record(gpu::CommandList& commands, DeformedMesh& mesh, Surfels& surfels,
              RayHierarchy& hierarchy) const;

 private:
  gpu::Pipeline leaves_;
  gpu::Pipeline nodes_;
};

}  // namespace opaline::passes
