#include "passes/scatter/nearby_pass.h"

#include <vector>

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/seen_parts.h"

namespace opaline::passes {

NearbyPass::NearbyPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      linear_(device, gpu::Filter::Linear),
      dipole_(makePipelines(device, ScatterTransport::Dipole)),
      betterDipole_(makePipelines(device, ScatterTransport::BetterDipole)) {}

NearbyPass::PerTransport NearbyPass::makePipelines(gpu::Device& device,
                                                   ScatterTransport transport) {
  const auto make = [&](std::uint32_t withPaint) -> Pipelines {
    return {{device, "nearby over vertices", {.transport = transport, .withPaint = withPaint}},
            {{device,
              "nearby over fragments",
              {.transport = transport, .withPaint = withPaint, .withNormals = 0}},
             {device,
              "nearby over fragments",
              {.transport = transport, .withPaint = withPaint, .withNormals = 1}}}};
  };
  return {make(0), make(1)};
}

void NearbyPass::overPlaces(gpu::CommandList& commands, ScatterTransport transport,
                            ScatterSite site, const Inputs& inputs, const Places& places) const {
  commands.beginPass("nearby");
  commands.bind(pipelines(transport, inputs.tables).vertices,
                {.frame = inputs.frame.data,
                 .positions = places.positions,
                 .objectOf = places.objectOf,
                 .exitances = places.exitances,
                 .objects = inputs.tables.objects,
                 .media = inputs.tables.media,
                 .shadowMaps = {inputs.shadows.depth, nearest_},
                 .skyIrradiance = {inputs.sky.irradiance, linear_},
                 .nodes = inputs.surfels.nodes,
                 .sources = inputs.surfels.sources,
                 .surfelNormals = inputs.surfels.normals,
                 .normals = places.normals,
                 .order = places.order,
                 .skyShares = inputs.surfels.skyShares,
                 .throughPaint = inputs.tables.paint.throughSurfels},
                {.vertexCount = places.count, .site = site});
  commands.dispatchLinear(places.count, roundsOfWalk);
  commands.endPass();
}

void NearbyPass::overFragments(gpu::CommandList& commands, ScatterTransport transport,
                               ScatterSite site, const Inputs& inputs,
                               const SeenSurfaces& seen) const {
  commands.beginPass("nearby");
  dispatchParts(commands, seen.surfaces,
                pipelines(transport, inputs.tables).fragments.of(inputs.tables.surfaces.anyNormals),
                {.listedPlaces = listedPlaces(seen, nearest_),
                 .surfaceMaterials = surfaceMaterials(inputs.textures),
                 .exitances = seen.surfaces.light,
                 .objects = inputs.tables.objects,
                 .media = inputs.tables.media,
                 .shadowMaps = {inputs.shadows.depth, nearest_},
                 .skyIrradiance = {inputs.sky.irradiance, linear_},
                 .nodes = inputs.surfels.nodes,
                 .sources = inputs.surfels.sources,
                 .surfelNormals = inputs.surfels.normals,
                 .skyShares = inputs.surfels.skyShares,
                 .throughPaint = inputs.tables.paint.throughSurfels},
                {.first = 0, .site = site});
  commands.endPass();
}

}  // namespace opaline::passes
