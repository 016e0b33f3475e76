#include "passes/shade/reflected_sky_pass.h"

#include <algorithm>
#include <cmath>

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/seen_parts.h"

namespace opaline::passes {

namespace {

// Of one sample: a mirror needs one, as antialiasing softens its edges; a wide lobe a few.
std::uint32_t raysOfSample(float alpha) {
  constexpr float raysOfAlpha = 16;
  return static_cast<std::uint32_t>(std::clamp(std::round(raysOfAlpha * alpha), 1.0F, 8.0F));
}

// Of a surface, with which all of a band go in one dispatch: few of them need rays of their own.
constexpr std::uint32_t raysAtOnce = 8;

}  // namespace

ReflectedSkyPass::ReflectedSkyPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      blocks_(device, "blocks of reflected sky", rayShader<shaders::ShadeSkyBlocks>(device)),
      known_(device, "sky known of blocks"),
      pixels_(device, "reflected sky", rayShader<shaders::ShadeReflectedSky>(device)) {}

void ReflectedSkyPass::record(gpu::CommandList& commands, const Inputs& inputs,
                              std::uint32_t firstRow, const SeenSurfaces& seen) const {
  VisibleSurfaces& surfaces = seen.surfaces;
  const float alpha = inputs.roughness * inputs.roughness;
  const std::uint32_t rays = raysOfSample(alpha);
  const std::uint32_t raysInAll = rays * inputs.samples;
  const std::uint32_t nodeCount = inputs.surfels.tree.nodeCount;
  commands.beginPass("reflected sky");
  commands.bind(blocks_,
                {.seenPlaces = seenPlaces(seen, nearest_),
                 .objects = inputs.tables.objects,
                 .pieceCorners = inputs.rays.corners,
                 .rayHierarchy = passes::rays(inputs.rays),
                 .skyBlocks = surfaces.skyBlocks},
                {.first = firstRow,
                 .nodeCount = nodeCount,
                 .piecesPerSurfel = inputs.surfels.piecesPerSurfel,
                 .rays = rays,
                 .raysInAll = raysInAll,
                 .alpha = alpha});
  const auto groupsOf = [](std::uint32_t pixels) { return (pixels + 31) / 32; };
  commands.dispatch(groupsOf(surfaces.words.extent().width), groupsOf(surfaces.rowsOfBand));
  commands.fill(surfaces.askedCounts, 0);
  dispatchWhole(commands, surfaces.counts, known_,
                {.listedPlaces = listedPlaces(seen, nearest_),
                 .objects = inputs.tables.objects,
                 .light = surfaces.light,
                 .skyBlocks = {surfaces.skyBlocks, nearest_},
                 .surfaces = surfaces.askedOfSky,
                 .surfaceCounts = surfaces.askedCounts});
  const shaders::ShadeReflectedSky::Bindings bindings{.listedPlaces = listedPlaces(seen, nearest_),
                                                      .objects = inputs.tables.objects,
                                                      .pieceCorners = inputs.rays.corners,
                                                      .rayHierarchy = passes::rays(inputs.rays),
                                                      .light = surfaces.light,
                                                      .asked = surfaces.askedOfSky,
                                                      .askedCount = surfaces.askedCounts};
  const shaders::ShadeReflectedSky::Push push{.first = 0,
                                              .nodeCount = nodeCount,
                                              .piecesPerSurfel = inputs.surfels.piecesPerSurfel,
                                              .rays = rays,
                                              .raysInAll = raysInAll,
                                              .alpha = alpha};
  if (raysInAll <= raysAtOnce)
    dispatchWhole(commands, surfaces.askedCounts, pixels_, bindings, push);
  else
    dispatchParts(commands, surfaces.askedCounts, surfaces.parts, pixels_, bindings, push);
  commands.endPass();
}

}  // namespace opaline::passes
