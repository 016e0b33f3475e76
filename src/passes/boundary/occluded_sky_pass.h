#pragma once

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/boundary/occluded_sky.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Adds the sky's light to what surfels have gathered of lights, as far as the clusters around them
/// see the sky.
class OccludedSkyPass {
 public:
  explicit OccludedSkyPass(gpu::Device& device);

  void record(gpu::CommandList& commands, SceneTables& tables, Sky& sky, Clusters& clusters,
              Surfels& surfels) const;

 private:
  gpu::Sampler linear_;
  gpu::Compute<shaders::BoundaryOccludedSky> pass_;
};

}  // namespace opaline::passes
