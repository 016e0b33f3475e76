#pragma once

#include <cstddef>
#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/shade/shade.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Radiance towards the camera from exitance, with the reflection on top; adds antialiasing
/// samples.
class ShadePass {
 public:
  explicit ShadePass(gpu::Device& device);

  static gpu::GpuImage makeRadiance(gpu::Device& device, std::uint32_t width, std::uint32_t height);

  struct Inputs {
    FrameView& frame;
    SceneTables& tables;
    ShadowMaps& shadows;
    VisibleSurface& surface;
    gpu::GpuImage& exitance;  ///< of what is visible
    Sky& sky;
    ReflectedSky& reflectedSky;
    std::uint32_t sample;  ///< of `samples`
    std::uint32_t samples;
    float roughness;
    bool specular;
    bool mirrorsSky;  ///< `reflectedSky` says how much of it
  };
  void record(gpu::CommandList& commands, const Inputs& inputs, gpu::GpuImage& radiance) const;

 private:
  gpu::Sampler nearest_;
  gpu::Sampler linear_;
  gpu::Compute<shaders::ShadeShade> pipeline_;
};

}  // namespace opaline::passes
