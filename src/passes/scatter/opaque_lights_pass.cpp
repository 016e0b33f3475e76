#include "passes/scatter/opaque_lights_pass.h"

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/seen_parts.h"

namespace opaline::passes {

namespace {

// The rounds of scatter/opaque_area_lights.comp.
enum Round : std::uint32_t { AskingFirst, Comparing, AskingAgain, Averaging, Summing };

// Rays to each light that scatter/opaque_area_vertices.comp sends.
constexpr std::uint32_t raysOfVertex = 16;

}  // namespace

OpaqueLightsPass::OpaqueLightsPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      vertices_(device, "area lights at opaque vertices"),
      fragments_(device, "area lights at opaque fragments") {}

void OpaqueLightsPass::overVertices(gpu::CommandList& commands, const Inputs& inputs,
                                    ScatterSite site, const Places& vertices) const {
  commands.beginPass("lights on opaque");
  commands.bind(vertices_.of(inputs.between, inputs.tables),
                {.lightThrough = lightThrough(inputs.between, inputs.tables),
                 .frame = inputs.frame.data,
                 .positions = vertices.positions,
                 .normals = vertices.normals,
                 .objects = inputs.tables.objects,
                 .media = inputs.tables.media,
                 .objectOf = vertices.objectOf,
                 .irradiances = vertices.exitances},
                {.vertexCount = vertices.count,
                 .sides = inputs.tables.sidesOfVertices(),
                 .site = site,
                 .nodeCount = inputs.between.surfels.tree.nodeCount,
                 .piecesPerSurfel = inputs.between.surfels.piecesPerSurfel});
  commands.dispatchLinear(
      inputs.tables.sidesOfVertices() * vertices.count,
      inputs.areaLights * (raysOfVertex * roundsOfWalk + inputs.between.rounds()));
  commands.endPass();
}

void OpaqueLightsPass::overFragments(gpu::CommandList& commands, const Inputs& inputs,
                                     ScatterSite site, Side side, std::uint32_t firstRow,
                                     const SeenSurfaces& seen) const {
  VisibleSurfaces& surfaces = seen.surfaces;
  commands.beginPass("lights on opaque");
  for (const Round round : {AskingFirst, Comparing, AskingAgain, Averaging, Summing}) {
    const bool even = round % 2 == 0;
    dispatchParts(commands, surfaces, fragments_.of(inputs.between, inputs.tables),
                  {.listedPlaces = listedPlaces(seen, nearest_),
                   .lightThrough = lightThrough(inputs.between, inputs.tables),
                   .objects = inputs.tables.objects,
                   .media = inputs.tables.media,
                   .materials = surfaces.materials,
                   .irradiances = surfaces.light,
                   .sharesBefore = surfaces.ofPixels[even ? 1 : 0],
                   .lightShares = surfaces.ofPixels[even ? 0 : 1]},
                  {.first = 0,
                   .site = site,
                   .nodeCount = inputs.between.surfels.tree.nodeCount,
                   .piecesPerSurfel = inputs.between.surfels.piecesPerSurfel,
                   .firstRow = firstRow,
                   .rows = surfaces.rowsFrom(firstRow),
                   .round = round,
                   .behind = side == Side::Other});
  }
  commands.endPass();
}

}  // namespace opaline::passes
