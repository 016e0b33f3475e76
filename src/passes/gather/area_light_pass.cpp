#include "passes/gather/area_light_pass.h"

#include "gpu/device.h"
#include "passes/mechanics.h"

namespace opaline::passes {

namespace {

// Rays of an invocation; most need only the first few.
constexpr std::uint32_t usualRays = 16;

}  // namespace

AreaLightPass::AreaLightPass(gpu::Device& device)
    : shadows_(device, "soft shadows"),
      add_{{device, "area lights", {.withNormals = 0}},
           {device, "area lights", {.withNormals = 1}}} {}

void AreaLightPass::record(gpu::CommandList& commands, const Inputs& inputs,
                           Surfels& surfels) const {
  commands.beginPass("area lights");
  const std::uint32_t pieces = surfels.count * surfels.piecesPerSurfel;
  for (std::uint32_t light = inputs.first; light < inputs.end; ++light) {
    commands.bind(shadows_,
                  {.frame = inputs.frame.data,
                   .positions = inputs.mesh.positions,
                   .normals = inputs.mesh.normals,
                   .pieces = surfels.pieces,
                   .objects = inputs.tables.objects,
                   .media = inputs.tables.media,
                   .pieceCorners = inputs.rays.corners,
                   .rayHierarchy = rays(inputs.rays),
                   .visibilities = surfels.visibilities},
                  {.pieceCount = pieces,
                   .piecesPerSurfel = surfels.piecesPerSurfel,
                   .nodeCount = surfels.tree.nodeCount,
                   .light = light});
    commands.dispatchLinear(pieces, usualRays * roundsOfWalk);
  }
  commands.bind(add_.of(inputs.tables.surfaces.anyNormals),
                {.frame = inputs.frame.data,
                 .positions = inputs.mesh.positions,
                 .normals = inputs.mesh.normals,
                 .pieces = surfels.pieces,
                 .objects = inputs.tables.objects,
                 .media = inputs.tables.media,
                 .visibilities = surfels.visibilities,
                 .sources = surfels.sources,
                 .tilts = inputs.tables.surfaces.tilts},
                {.surfelCount = surfels.count, .piecesPerSurfel = surfels.piecesPerSurfel});
  commands.dispatchLinear(surfels.count);
  commands.endPass();
}

}  // namespace opaline::passes
