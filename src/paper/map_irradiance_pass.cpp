#include "paper/map_irradiance_pass.h"

#include "gpu/device.h"

namespace opaline::paper {

MapIrradiancePass::MapIrradiancePass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest), pipeline_(device, "irradiance of the map") {}

void MapIrradiancePass::record(gpu::CommandList& commands, const passes::SeenSurfaces& seen,
                               FlatScene& flat, Map& map, gpu::GpuImage& irradiance) const {
  commands.beginPass("seen irradiance");
  commands.bind(pipeline_, {.seenPlaces = passes::seenPlaces(seen, nearest_),
                            .nearFlux = {map.sources.nearFlux, nearest_},
                            .seen = irradiance,
                            .corners = flat.corners,
                            .cornerIndices = flat.indices,
                            .charts = map.sources.charts});
  commands.dispatchTiles(irradiance);
  commands.endPass();
}

}  // namespace opaline::paper
