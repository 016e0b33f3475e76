#pragma once

#include <vector>

#include "gpu/pipeline.h"
#include "opaline/scene.h"
#include "passes/products.h"
#include "shaders/sky/reflected.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Makes the sky: what of it enters surfaces, and what these reflect of it. For set-up.
class SkyPass {
 public:
  explicit SkyPass(gpu::Device& device);

  /// For surfaces of that roughness and these indices of refraction, and, where `glossy`, for
  /// such as have any roughness.
  Sky makeSky(gpu::Device& device, const Lighting& lighting, float roughness,
              const std::vector<double>& etas, bool glossy) const;
  /// Takes up other indices of refraction, without another look at the environment.
  static void takeEtas(gpu::Device& device, const std::vector<double>& etas, Sky& sky);

 private:
  /// One level for each roughness, each of half the edge of the last.
  gpu::GpuImage reflectedOf(gpu::Device& device, const Lighting& lighting,
                            const std::vector<float>& roughnesses, std::uint32_t edge) const;

  gpu::Sampler sampler_;
  gpu::Compute<shaders::SkyReflected> reflected_;
};

}  // namespace opaline::passes
