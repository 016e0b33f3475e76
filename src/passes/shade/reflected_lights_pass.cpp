#include "passes/shade/reflected_lights_pass.h"

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/seen_parts.h"

namespace opaline::passes {

namespace {

gpu::Compute<shaders::ShadeReflectedLights> make(
    gpu::Device& device, const shaders::ShadeReflectedLights::Constants& constants) {
  return {device, "reflected lights", constants};
}

}  // namespace

ReflectedLightsPass::ReflectedLightsPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      bare_(make(device, {.withOwnSurfaces = 0, .withMaterials = 0})),
      withMaterials_{make(device, {.withOwnSurfaces = 0, .withMaterials = 1}),
                     make(device, {.withOwnSurfaces = 1, .withMaterials = 1})} {}

void ReflectedLightsPass::record(gpu::CommandList& commands, const Inputs& inputs,
                                 const SeenSurfaces& seen) const {
  commands.beginPass("reflected lights");
  const auto& pipeline =
      seen.surfaces.kept.materials ? withMaterials_.of(inputs.tables.surfaces.any) : bare_;
  dispatchParts(commands, seen.surfaces, pipeline,
                {.listedPlaces = listedPlaces(seen, nearest_),
                 .objects = inputs.tables.objects,
                 .media = inputs.tables.media,
                 .pieceCorners = inputs.rays.corners,
                 .rayHierarchy = rays(inputs.rays),
                 .specularAlbedo = inputs.tables.specularAlbedo,
                 .light = seen.surfaces.light,
                 .lobes = inputs.tables.reflectionLobes,
                 .gloss = inputs.opaque.gloss,
                 .glossLobes = inputs.opaque.lobes,
                 .materials = seen.surfaces.materials,
                 .piecesOfTriangles = inputs.surfels.piecesOfTriangles,
                 .visibilities = inputs.surfels.visibilities},
                {.first = 0,
                 .nodeCount = inputs.surfels.tree.nodeCount,
                 .piecesPerSurfel = inputs.surfels.piecesPerSurfel,
                 .pieceCount = inputs.surfels.count * inputs.surfels.piecesPerSurfel,
                 .triangleCount = inputs.surfels.triangleCount});
  commands.endPass();
}

}  // namespace opaline::passes
