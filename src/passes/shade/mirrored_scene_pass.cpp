#include "passes/shade/mirrored_scene_pass.h"

#include <algorithm>

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/seen_parts.h"

namespace opaline::passes {

namespace {

// The rounds of shade/mirrored_scene.comp.
enum Round : std::uint32_t { SendingRays, Averaging, Taking };

}  // namespace

MirroredScenePass::MirroredScenePass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest), pipeline_(device, "mirrored scene") {}

void MirroredScenePass::record(gpu::CommandList& commands, const Inputs& inputs,
                               std::uint32_t firstRow, const SeenSurfaces& seen) const {
  VisibleSurfaces& surfaces = seen.surfaces;
  const bool hasOpaque = static_cast<bool>(inputs.tables.opaqueExitances);
  gpu::Buffer& exitances = inputs.insides ? inputs.clusters.exitances : inputs.clusters.means;
  commands.beginPass("mirrored scene");
  for (const Round round : {SendingRays, Averaging, Taking}) {
    const bool even = round % 2 == 0;
    dispatchParts(commands, surfaces, pipeline_,
                  {.listedPlaces = listedPlaces(seen, nearest_),
                   .objects = inputs.tables.objects,
                   .pieceCorners = inputs.rays.corners,
                   .rayHierarchy = passes::rays(inputs.rays),
                   .materials = surfaces.materials,
                   .clusterOfSurfel = inputs.clusters.clusterOfSurfel,
                   .exitances = exitances,
                   .opaqueExitances = hasOpaque ? inputs.tables.opaqueExitances : exitances,
                   .clusterNodes = inputs.clusters.nodes,
                   .clusters = inputs.clusters.clusters,
                   .skyShares = surfaces.skyShares,
                   .metBefore = surfaces.ofPixels[even ? 1 : 0],
                   .metNow = surfaces.ofPixels[even ? 0 : 1]},
                  {.first = 0,
                   .nodeCount = inputs.surfels.tree.nodeCount,
                   .piecesPerSurfel = inputs.surfels.piecesPerSurfel,
                   .translucent = inputs.onTranslucent,
                   .insides = inputs.insides,
                   .alpha = inputs.roughness * inputs.roughness,
                   .ownSurfaces = inputs.tables.surfaces.any,
                   .firstRow = firstRow,
                   .rows = surfaces.rowsFrom(firstRow),
                   .round = round});
  }
  commands.endPass();
}

}  // namespace opaline::passes
