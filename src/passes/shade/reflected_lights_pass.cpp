#include "passes/shade/reflected_lights_pass.h"

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/seen_parts.h"

namespace opaline::passes {

ReflectedLightsPass::ReflectedLightsPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      pipelines_{{device,
                  "reflected lights",
                  rayShader<shaders::ShadeReflectedLights>(device),
                  {.withOwnSurfaces = 0}},
                 {device,
                  "reflected lights",
                  rayShader<shaders::ShadeReflectedLights>(device),
                  {.withOwnSurfaces = 1}}} {}

void ReflectedLightsPass::record(gpu::CommandList& commands, const Inputs& inputs,
                                 const SeenSurfaces& seen) const {
  commands.beginPass("reflected lights");
  dispatchParts(commands, seen.surfaces, pipelines_.of(inputs.tables.surfaces.any),
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
                 .materials = seen.surfaces.materials},
                {.first = 0,
                 .nodeCount = inputs.surfels.tree.nodeCount,
                 .piecesPerSurfel = inputs.surfels.piecesPerSurfel});
  commands.endPass();
}

}  // namespace opaline::passes
