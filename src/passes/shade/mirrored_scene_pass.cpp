#include "passes/shade/mirrored_scene_pass.h"

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/seen_parts.h"

namespace opaline::passes {

MirroredScenePass::MirroredScenePass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      pipeline_(device, "mirrored scene", rayShader<shaders::ShadeMirroredScene>(device)) {}

void MirroredScenePass::record(gpu::CommandList& commands, const Inputs& inputs,
                               const SeenSurfaces& seen) const {
  const bool hasOpaque = static_cast<bool>(inputs.tables.opaqueExitances);
  commands.beginPass("mirrored scene");
  dispatchParts(
      commands, seen.surfaces, pipeline_,
      {.listedPlaces = listedPlaces(seen, nearest_),
       .objects = inputs.tables.objects,
       .pieceCorners = inputs.rays.corners,
       .rayHierarchy = passes::rays(inputs.rays),
       .materials = seen.surfaces.materials,
       .clusterOfSurfel = inputs.clusters.clusterOfSurfel,
       .exitances = inputs.clusters.exitances,
       .opaqueExitances = hasOpaque ? inputs.tables.opaqueExitances : inputs.clusters.exitances,
       .clusterNodes = inputs.clusters.nodes,
       .clusters = inputs.clusters.clusters,
       .light = seen.surfaces.light},
      {.first = 0,
       .nodeCount = inputs.surfels.tree.nodeCount,
       .piecesPerSurfel = inputs.surfels.piecesPerSurfel,
       .translucent = inputs.onTranslucent,
       .insides = inputs.insides,
       .alpha = inputs.roughness * inputs.roughness,
       .ownSurfaces = inputs.tables.surfaces.any});
  commands.endPass();
}

}  // namespace opaline::passes
