#pragma once

#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "passes/variants.h"
#include "shaders/shade/known_sky.comp.h"
#include "shaders/shade/reflected_sky.comp.h"
#include "shaders/shade/sky_blocks.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Finds how much of what the surface mirrors towards the camera is sky, and not the scene itself,
/// by rays from the corners of blocks of 4×4 pixels or their quarters where those agree, else from
/// every visible pixel. What is rougher takes more of them.
class ReflectedSkyPass {
 public:
  explicit ReflectedSkyPass(gpu::Device& device);

  struct Inputs {
    SceneTables& tables;
    Surfels& surfels;
    RayHierarchy& rays;
    std::uint32_t samples;  ///< of a pixel
    float roughness;
  };
  /// Of the band of the picture from `firstRow` on. Leaves it in VisibleSurfaces::skyShares.
  void record(gpu::CommandList& commands, const Inputs& inputs, std::uint32_t firstRow,
              const SeenSurfaces& seen) const;

 private:
  gpu::Sampler nearest_;
  Variants<shaders::ShadeSkyBlocks> blocks_;
  gpu::Compute<shaders::ShadeKnownSky> known_;
  Variants<shaders::ShadeReflectedSky> pixels_;
};

}  // namespace opaline::passes
