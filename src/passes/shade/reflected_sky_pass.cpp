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

}  // namespace

ReflectedSkyPass::ReflectedSkyPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      blocks_(device, "blocks of reflected sky", rayShader<shaders::ShadeSkyBlocks>(device)),
      pixels_(device, "reflected sky", rayShader<shaders::ShadeReflectedSky>(device)) {}

void ReflectedSkyPass::record(gpu::CommandList& commands, const Inputs& inputs,
                              std::uint32_t firstRow, const SeenSurfaces& seen) const {
  VisibleSurfaces& surfaces = seen.surfaces;
  const float alpha = inputs.roughness * inputs.roughness;
  const std::uint32_t rays = raysOfSample(alpha);
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
                 .raysInAll = rays * inputs.samples,
                 .alpha = alpha});
  const auto groupsOf = [](std::uint32_t pixels) { return (pixels + 15) / 16; };
  commands.dispatch(groupsOf(surfaces.words.extent().width), groupsOf(surfaces.rowsOfBand));
  dispatchParts(commands, surfaces, pixels_,
                {.listedPlaces = listedPlaces(seen, nearest_),
                 .objects = inputs.tables.objects,
                 .pieceCorners = inputs.rays.corners,
                 .rayHierarchy = passes::rays(inputs.rays),
                 .light = surfaces.light,
                 .skyBlocks = {surfaces.skyBlocks, nearest_}},
                {.first = 0,
                 .nodeCount = nodeCount,
                 .piecesPerSurfel = inputs.surfels.piecesPerSurfel,
                 .rays = rays,
                 .raysInAll = rays * inputs.samples,
                 .alpha = alpha});
  commands.endPass();
}

}  // namespace opaline::passes
