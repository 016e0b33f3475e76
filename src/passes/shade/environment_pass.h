#pragma once

#include "gpu/image.h"
#include "gpu/pipeline.h"
#include "opaline/image.h"
#include "shaders/shade/environment.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// The environment as the surface's GGX lobe reflects it, one cube map. For set-up; blocks.
class EnvironmentPass {
 public:
  explicit EnvironmentPass(gpu::Device& device);

  /// A cube of one black texel, to be bound where there is no environment.
  static gpu::GpuImage makeBlack(gpu::Device& device);

  gpu::GpuImage makeCube(gpu::Device& device, const Image& latLong, float roughness) const;

 private:
  gpu::Sampler sampler_;
  gpu::Compute<shaders::ShadeEnvironment> pipeline_;
};

}  // namespace opaline::passes
