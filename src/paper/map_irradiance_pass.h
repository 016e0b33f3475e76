#pragma once

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "paper/products.h"
#include "passes/products.h"
#include "shaders/map_irradiance.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::paper {

/// Shows the map's irradiance where the camera sees it.
class MapIrradiancePass {
 public:
  explicit MapIrradiancePass(gpu::Device& device);

  void record(gpu::CommandList& commands, const passes::SeenSurfaces& seen, FlatScene& flat,
              Map& map, gpu::GpuImage& irradiance) const;

 private:
  gpu::Sampler nearest_;
  gpu::Compute<shaders::MapIrradiance> pipeline_;
};

}  // namespace opaline::paper
