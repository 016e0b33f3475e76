#pragma once

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/shade/seen_irradiance.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Shows the irradiance of the surfels that the camera sees.
class SeenIrradiancePass {
 public:
  explicit SeenIrradiancePass(gpu::Device& device);

  /// For set-up, not for frames: rgb E, one texel per pixel.
  static gpu::GpuImage makeImage(gpu::Device& device, VkExtent2D extent);

  void record(gpu::CommandList& commands, SeenSurfels& seen, Surfels& surfels,
              gpu::GpuImage& irradiance) const;

 private:
  gpu::Compute<shaders::ShadeSeenIrradiance> pipeline_;
};

}  // namespace opaline::passes
