#include "passes/shade/reflected_sky_pass.h"

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/seen_parts.h"

namespace opaline::passes {

ReflectedSkyPass::ReflectedSkyPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      blocks_{{device,
               "blocks of reflected sky",
               rayShader<shaders::ShadeSkyBlocks>(device),
               {.withOwnSurfaces = 0}},
              {device,
               "blocks of reflected sky",
               rayShader<shaders::ShadeSkyBlocks>(device),
               {.withOwnSurfaces = 1}}},
      pixels_{{device,
               "reflected sky",
               rayShader<shaders::ShadeReflectedSky>(device),
               {.withOwnSurfaces = 0}},
              {device,
               "reflected sky",
               rayShader<shaders::ShadeReflectedSky>(device),
               {.withOwnSurfaces = 1}}} {}

void ReflectedSkyPass::record(gpu::CommandList& commands, const Inputs& inputs,
                              std::uint32_t firstRow, const SeenSurfaces& seen) const {
  VisibleSurfaces& surfaces = seen.surfaces;
  const float alpha = inputs.roughness * inputs.roughness;
  const bool own = inputs.tables.surfaces.any;
  const std::uint32_t nodeCount = inputs.surfels.tree.nodeCount;
  commands.beginPass("reflected sky");
  commands.bind(blocks_.of(own),
                {.seenPlaces = seenPlaces(seen, nearest_),
                 .objects = inputs.tables.objects,
                 .pieceCorners = inputs.rays.corners,
                 .rayHierarchy = passes::rays(inputs.rays),
                 .skyBlocks = surfaces.skyBlocks,
                 .media = inputs.tables.media},
                {.first = firstRow,
                 .nodeCount = nodeCount,
                 .piecesPerSurfel = inputs.surfels.piecesPerSurfel,
                 .samples = inputs.samples,
                 .alpha = alpha});
  const auto groupsOf = [](std::uint32_t pixels) { return (pixels + 15) / 16; };
  commands.dispatch(groupsOf(surfaces.words.extent().width), groupsOf(surfaces.rowsOfBand));
  dispatchParts(commands, surfaces, pixels_.of(own),
                {.listedPlaces = listedPlaces(seen, nearest_),
                 .objects = inputs.tables.objects,
                 .pieceCorners = inputs.rays.corners,
                 .rayHierarchy = passes::rays(inputs.rays),
                 .light = surfaces.light,
                 .skyBlocks = {surfaces.skyBlocks, nearest_},
                 .materials = surfaces.materials},
                {.first = 0,
                 .nodeCount = nodeCount,
                 .piecesPerSurfel = inputs.surfels.piecesPerSurfel,
                 .samples = inputs.samples,
                 .alpha = alpha});
  commands.endPass();
}

}  // namespace opaline::passes
