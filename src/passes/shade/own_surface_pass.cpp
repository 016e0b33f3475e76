#include "passes/shade/own_surface_pass.h"

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/seen_parts.h"

namespace opaline::passes {

OwnSurfacePass::OwnSurfacePass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      tilts_(device, "normals of pieces"),
      seen_(device, "translucent surfaces") {}

void OwnSurfacePass::makeTilts(gpu::Device& device, Surfels& surfels, OpaqueTables& textures,
                               SceneTables& tables) const {
  OwnSurfaces& own = tables.surfaces;
  const bool wanted = own.anyNormals && surfels.triangleOfPiece;
  const std::uint32_t pieces = surfels.count * surfels.piecesPerSurfel;
  own.tilts = makeRoom<shared::vec4>(device, "normals of pieces", wanted ? pieces : 0);
  if (!wanted) return;
  gpu::CommandList commands(device, "normals of pieces");
  commands.begin();
  commands.bind(tilts_,
                {.surfaceMaterials = surfaceMaterials(textures),
                 .objects = tables.objects,
                 .media = tables.media,
                 .pieces = surfels.pieces,
                 .triangleOfPiece = surfels.triangleOfPiece,
                 .tilts = own.tilts},
                {.pieceCount = pieces});
  commands.dispatchLinear(pieces);
  commands.submit();
}

void OwnSurfacePass::record(gpu::CommandList& commands, SceneTables& tables, OpaqueTables& textures,
                            float roughness, const SeenSurfaces& seen) const {
  commands.beginPass("shade");
  dispatchParts(commands, seen.surfaces, seen_,
                {.listedPlaces = listedPlaces(seen, nearest_),
                 .surfaceMaterials = surfaceMaterials(textures),
                 .objects = tables.objects,
                 .media = tables.media,
                 .materials = seen.surfaces.materials},
                {.first = 0, .alpha = roughness * roughness});
  commands.endPass();
}

}  // namespace opaline::passes
