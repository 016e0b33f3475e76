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

/// Makes the sky's tables: light that enters surfaces, and light that they reflect. For set-up.
class SkyPass {
 public:
  explicit SkyPass(gpu::Device& device);

  /// Makes a sky for surfaces of that roughness and these indices of refraction and, with `glossy`,
  /// for surfaces of any roughness.
  Sky makeSky(gpu::Device& device, const Lighting& lighting, float roughness,
              const std::vector<double>& etas, bool glossy) const;
  /// Adapts the sky to other indices of refraction without reading the environment again.
  static void takeEtas(gpu::Device& device, const std::vector<double>& etas, Sky& sky);

 private:
  /// One level for each roughness; each has half the edge of the one before.
  gpu::GpuImage reflectedOf(gpu::Device& device, const Lighting& lighting,
                            const std::vector<float>& roughnesses, std::uint32_t edge) const;

  gpu::Sampler sampler_;
  gpu::Compute<shaders::SkyReflected> reflected_;
};

}  // namespace opaline::passes
