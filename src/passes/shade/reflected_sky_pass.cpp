#include "passes/shade/reflected_sky_pass.h"

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/seen_parts.h"
#include "shaders/shared/sky_rays.h"

namespace opaline::passes {

namespace {

// The most rays per surface for which a band is one dispatch: few surfaces need rays of their own.
constexpr std::uint32_t raysAtOnce = 8;

}  // namespace

ReflectedSkyPass::ReflectedSkyPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      blocks_{{device, "blocks of reflected sky", {.withOwnSurfaces = 0}},
              {device, "blocks of reflected sky", {.withOwnSurfaces = 1}}},
      known_(device, "sky known of blocks"),
      pixels_{{device, "reflected sky", {.withOwnSurfaces = 0}},
              {device, "reflected sky", {.withOwnSurfaces = 1}}} {}

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
  const auto groupsOf = [](std::uint32_t pixels) { return (pixels + 31) / 32; };
  commands.dispatch(groupsOf(surfaces.words.extent().width), groupsOf(surfaces.rowsOfBand));
  dispatchWhole(commands, surfaces.counts, known_,
                {.listedPlaces = listedPlaces(seen, nearest_),
                 .objects = inputs.tables.objects,
                 .skyShares = surfaces.skyShares,
                 .skyBlocks = {surfaces.skyBlocks, nearest_},
                 .surfaces = surfaces.asked,
                 .surfaceCounts = surfaces.countsOf(Asked::OfSky)},
                {.firstRow = firstRow, .rows = surfaces.rowsFrom(firstRow), .alpha = alpha});
  const shaders::ShadeReflectedSky::Bindings bindings{
      .listedPlaces = listedPlaces(seen, nearest_),
      .objects = inputs.tables.objects,
      .pieceCorners = inputs.rays.corners,
      .rayHierarchy = passes::rays(inputs.rays),
      .skyShares = surfaces.skyShares,
      .materials = surfaces.materials,
      .asked = surfaces.asked,
      .askedCount = surfaces.countsOf(Asked::OfSky)};
  const shaders::ShadeReflectedSky::Push push{.first = 0,
                                              .nodeCount = nodeCount,
                                              .piecesPerSurfel = inputs.surfels.piecesPerSurfel,
                                              .samples = inputs.samples,
                                              .alpha = alpha};
  // Surfaces with their own roughness are all on the list, and may need many rays.
  const auto rays = static_cast<std::uint32_t>(shared::skyRaysOfSample(alpha));
  if (!own && rays * inputs.samples <= raysAtOnce)
    dispatchWhole(commands, surfaces.countsOf(Asked::OfSky), pixels_.of(own), bindings, push);
  else
    dispatchParts(commands, surfaces.countsOf(Asked::OfSky), surfaces.parts, pixels_.of(own),
                  bindings, push);
  commands.endPass();
}

}  // namespace opaline::passes
