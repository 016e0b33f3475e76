#pragma once

#include <glm/vec3.hpp>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "passes/variants.h"
#include "shaders/shade/seen_through.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Finds what is seen through thin parts of translucent bodies by light that they do not scatter.
class SeenThroughPass {
 public:
  explicit SeenThroughPass(gpu::Device& device);

  struct Inputs {
    SceneTables& tables;
    Surfels& surfels;
    RayHierarchy& rays;
    Clusters& clusters;  ///< with the light that leaves bodies
    Backdrop& backdrop;
    glm::vec3 ambient;  ///< radiance of the sky on top of the environment's
  };
  /// Writes shared::SeenMaterial::behind of translucent surfaces.
  void record(gpu::CommandList& commands, const Inputs& inputs, std::uint32_t firstRow,
              const SeenSurfaces& seen) const;

 private:
  gpu::Sampler nearest_;
  gpu::Sampler aroundHorizon_;
  VariantsOfTwo<shaders::ShadeSeenThrough> pipelines_;  ///< from the grid, with paint
};

}  // namespace opaline::passes
