#include "passes/shade/seen_through_pass.h"

#include <glm/vec4.hpp>

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/seen_parts.h"

namespace opaline::passes {

SeenThroughPass::SeenThroughPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      aroundHorizon_(device, gpu::Filter::Linear, gpu::Wrap::Repeat, gpu::Wrap::Clamp),
      pipelines_{{{device, "seen through", {.withPaint = 0, .onGrid = 0}},
                  {device, "seen through", {.withPaint = 1, .onGrid = 0}}},
                 {{device, "seen through", {.withPaint = 0, .onGrid = 1}},
                  {device, "seen through", {.withPaint = 1, .onGrid = 1}}}} {}

void SeenThroughPass::record(gpu::CommandList& commands, const Inputs& inputs,
                             std::uint32_t firstRow, const SeenSurfaces& seen) const {
  VisibleSurfaces& surfaces = seen.surfaces;
  Clusters& clusters = inputs.clusters;
  SceneTables& tables = inputs.tables;
  const shaders::ShadeSeenThrough::Bindings bindings{
      .listedPlaces = listedPlaces(seen, nearest_),
      .objects = tables.objects,
      .media = tables.media,
      .pieceCorners = inputs.rays.corners,
      .rayHierarchy = passes::rays(inputs.rays),
      .clusterPaints = tables.paint.clusters,
      .clusters = clusters.clusters,
      .ranges = clusters.ranges,
      .clusterOfSurfel = clusters.clusterOfSurfel,
      .exitances = clusters.exitances,
      .opaqueExitances = tables.opaqueExitances ? tables.opaqueExitances : clusters.exitances,
      .materials = surfaces.materials,
      .environment = {inputs.backdrop.environment, aroundHorizon_},
      .clusterNodes = clusters.nodes,
      .pieces = inputs.surfels.pieces,
      .found = surfaces.ofPixels[0],
      .entryOfPixel = surfaces.entryOfPixel,
      .means = clusters.means};
  const shaders::ShadeSeenThrough::Push push{.ambient = glm::vec4(inputs.ambient, 0),
                                             .first = 0,
                                             .nodeCount = inputs.surfels.tree.nodeCount,
                                             .piecesPerSurfel = inputs.surfels.piecesPerSurfel,
                                             .ownSurfaces = tables.surfaces.any,
                                             .firstRow = firstRow,
                                             .rows = surfaces.rowsFrom(firstRow)};
  const bool painted = tables.paint.any;
  commands.beginPass("seen through");
  commands.bind(pipelines_.of(true, painted), bindings, push);
  const auto groupsOf = [](std::uint32_t pixels) { return (pixels + 15) / 16; };
  commands.dispatch(groupsOf(surfaces.words.extent().width), groupsOf(surfaces.rowsOfBand));
  dispatchParts(commands, surfaces, pipelines_.of(false, painted), bindings, push);
  commands.endPass();
}

}  // namespace opaline::passes
