#pragma once

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "opaline/scene.h"
#include "passes/products.h"
#include "shaders/shade/backdrop.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Begins the picture with what lies behind the surfaces: visible lights and, if requested, the
/// environment.
class BackdropPass {
 public:
  explicit BackdropPass(gpu::Device& device);

  /// `environment` includes its suns; null if only lights are visible. For set-up.
  static Backdrop makeBackdrop(gpu::Device& device, const Image* environment);

  struct Inputs {
    Backdrop& backdrop;
    Rgb ambient;
    std::uint32_t samples;  ///< per pixel
    bool fills;             ///< environment and ambient light are visible
  };
  /// After SurfacePass::draw() and before its list(), with as many samples.
  void record(gpu::CommandList& commands, const Inputs& inputs, const SeenSurfaces& seen,
              gpu::GpuImage& radiance) const;

 private:
  gpu::Sampler sampler_;
  gpu::Compute<shaders::ShadeBackdrop> backdrop_;
};

}  // namespace opaline::passes
