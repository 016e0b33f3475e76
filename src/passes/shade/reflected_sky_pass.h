#pragma once

#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/shade/reflected_sky.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Finds how much of what the surface mirrors towards the camera is sky, and not the scene itself,
/// by rays from every visible pixel. What is rougher takes more of them.
class ReflectedSkyPass {
 public:
  explicit ReflectedSkyPass(gpu::Device& device);

  static ReflectedSky makeSky(gpu::Device& device, std::uint32_t width, std::uint32_t height);

  struct Inputs {
    FrameView& frame;
    SceneTables& tables;
    VisibleSurface& surface;
    Surfels& surfels;
    RayHierarchy& rays;
    std::uint32_t sample;  ///< of `samples`
    std::uint32_t samples;
    float roughness;
  };
  void record(gpu::CommandList& commands, const Inputs& inputs, ReflectedSky& sky) const;

 private:
  gpu::Sampler nearest_;
  gpu::Compute<shaders::ShadeReflectedSky> pipeline_;
};

}  // namespace opaline::passes
