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

/// Finds the share of sky, as opposed to the scene itself, in what surfaces mirror towards the
/// camera. Rays start at the corners of blocks of 4×4 pixels, or of their quarters, if these agree,
/// else at every visible pixel. Rougher surfaces take more rays.
class ReflectedSkyPass {
 public:
  explicit ReflectedSkyPass(gpu::Device& device);

  struct Inputs {
    SceneTables& tables;
    Surfels& surfels;
    RayHierarchy& rays;
    std::uint32_t samples;  ///< per pixel
    float roughness;
  };
  /// Leaves the shares of the band that starts at `firstRow` in VisibleSurfaces::skyShares.
  void record(gpu::CommandList& commands, const Inputs& inputs, std::uint32_t firstRow,
              const SeenSurfaces& seen) const;

 private:
  gpu::Sampler nearest_;
  Variants<shaders::ShadeSkyBlocks> blocks_;
  gpu::Compute<shaders::ShadeKnownSky> known_;
  Variants<shaders::ShadeReflectedSky> pixels_;
};

}  // namespace opaline::passes
