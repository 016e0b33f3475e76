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

/// Begins the picture with what lies behind the surfaces: visible lights, and the environment where
/// that is asked for.
class BackdropPass {
 public:
  explicit BackdropPass(gpu::Device& device);

  /// `environment`: with its suns; none where only lights are seen. For set-up.
  static Backdrop makeBackdrop(gpu::Device& device, const Image* environment);

  struct Inputs {
    Backdrop& backdrop;
    Rgb ambient;
    std::uint32_t samples;  ///< of a pixel
    bool fills;             ///< environment and ambient light are seen
  };
  /// After SurfacePass::draw() and before its list(), with as many samples.
  void record(gpu::CommandList& commands, const Inputs& inputs, const SeenSurfaces& seen,
              gpu::GpuImage& radiance) const;

 private:
  gpu::Sampler sampler_;
  gpu::Compute<shaders::ShadeBackdrop> backdrop_;
};

}  // namespace opaline::passes
