#pragma once

#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "passes/variants.h"
#include "shaders/gather/area_lights.comp.h"
#include "shaders/gather/soft_shadows.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Adds the light of area lights to what surfels have gathered, with soft shadows by rays.
class AreaLightPass {
 public:
  explicit AreaLightPass(gpu::Device& device);

  struct Inputs {
    FrameView& frame;
    DeformedMesh& mesh;
    SceneTables& tables;
    RayHierarchy& rays;       ///< of this pose
    std::uint32_t first = 0;  ///< the first area light among the frame's lights
    std::uint32_t end = 0;
  };
  /// Leaves the visibility of each light in Surfels::visibilities, if there is room for it.
  void record(gpu::CommandList& commands, const Inputs& inputs, Surfels& surfels) const;

 private:
  gpu::Compute<shaders::GatherSoftShadows> shadows_;
  Variants<shaders::GatherAreaLights> add_;
};

}  // namespace opaline::passes
