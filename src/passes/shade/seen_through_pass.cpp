#include "passes/shade/seen_through_pass.h"

#include <glm/vec4.hpp>

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/seen_parts.h"

namespace opaline::passes {

SeenThroughPass::SeenThroughPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      aroundHorizon_(device, gpu::Filter::Linear, gpu::Wrap::Repeat, gpu::Wrap::Clamp),
      pipelines_{{device, "seen through", {.withPaint = 0}},
                 {device, "seen through", {.withPaint = 1}}} {}

void SeenThroughPass::record(gpu::CommandList& commands, const Inputs& inputs,
                             const SeenSurfaces& seen) const {
  Clusters& clusters = inputs.clusters;
  SceneTables& tables = inputs.tables;
  commands.beginPass("seen through");
  dispatchParts(commands, seen.surfaces, pipelines_.of(tables.paint.any),
                {.listedPlaces = listedPlaces(seen, nearest_),
                 .objects = tables.objects,
                 .media = tables.media,
                 .pieceCorners = inputs.rays.corners,
                 .rayHierarchy = passes::rays(inputs.rays),
                 .clusterPaints = tables.paint.clusters,
                 .clusters = clusters.clusters,
                 .ranges = clusters.ranges,
                 .clusterOfSurfel = clusters.clusterOfSurfel,
                 .exitances = clusters.exitances,
                 .opaqueExitances =
                     tables.opaqueExitances ? tables.opaqueExitances : clusters.exitances,
                 .materials = seen.surfaces.materials,
                 .environment = {inputs.backdrop.environment, aroundHorizon_},
                 .clusterNodes = clusters.nodes,
                 .pieces = inputs.surfels.pieces},
                {.first = 0,
                 .nodeCount = inputs.surfels.tree.nodeCount,
                 .piecesPerSurfel = inputs.surfels.piecesPerSurfel,
                 .ownSurfaces = tables.surfaces.any,
                 .ambient = glm::vec4(inputs.ambient, 0)});
  commands.endPass();
}

}  // namespace opaline::passes
