#include "paper/map_irradiance_pass.h"

#include "gpu/device.h"

namespace opaline::paper {

MapIrradiancePass::MapIrradiancePass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest), pipeline_(device, "irradiance of the map") {}

void MapIrradiancePass::record(gpu::CommandList& commands, passes::VisibleSurface& surface,
                               Map& map, gpu::GpuImage& irradiance) const {
  commands.beginPass("seen irradiance");
  commands.bind(pipeline_, {.surfacePosition = {surface.position, nearest_},
                            .surfacePlace = {map.place, nearest_},
                            .nearFlux = {map.sources.nearFlux, nearest_},
                            .seen = irradiance});
  commands.dispatchTiles(irradiance);
  commands.endPass();
}

}  // namespace opaline::paper
