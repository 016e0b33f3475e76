#include "passes/scatter/paint_pass.h"

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/seen_parts.h"
#include "shaders/shared/paint.h"

namespace opaline::passes {

PaintPass::PaintPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      clusters_(device, "paint of clusters"),
      surfels_(device, "paint of surfels"),
      sources_(device, "light through paint"),
      fragments_(device, "paint of fragments") {}

void PaintPass::makeTables(gpu::Device& device, Surfels& surfels, Clusters& clusters,
                           OpaqueTables& textures, SceneTables& tables) const {
  PaintTables& paint = tables.paint;
  paint.throughSurfels =
      makeRoom<shared::vec4>(device, "light through paint", paint.any ? surfels.count : 0);
  paint.clusters =
      makeRoom<shared::ClusterPaint>(device, "paint of clusters", paint.any ? clusters.count : 0);
  if (!paint.any || surfels.count == 0) return;
  gpu::CommandList commands(device, "paint");
  commands.begin();
  commands.bind(surfels_,
                {.surfaceMaterials = surfaceMaterials(textures),
                 .objects = tables.objects,
                 .media = tables.media,
                 .pieces = surfels.pieces,
                 .paintTables = paint.entries,
                 .through = paint.throughSurfels},
                {.surfelCount = surfels.count, .piecesPerSurfel = surfels.piecesPerSurfel});
  commands.dispatchLinear(surfels.count);
  if (clusters.count > 0) {
    commands.bind(clusters_,
                  {.surfaceMaterials = surfaceMaterials(textures),
                   .objects = tables.objects,
                   .media = tables.media,
                   .ranges = clusters.ranges,
                   .pieces = surfels.pieces,
                   .paintTables = paint.entries,
                   .clusterPaints = paint.clusters},
                  {.clusterCount = clusters.count, .piecesPerSurfel = surfels.piecesPerSurfel});
    commands.dispatchLinear(clusters.count);
  }
  commands.submit();
}

void PaintPass::overSources(gpu::CommandList& commands, PaintTables& paint,
                            Surfels& surfels) const {
  commands.beginPass("gather");
  commands.bind(sources_, {.through = paint.throughSurfels, .sources = surfels.sources},
                {.surfelCount = surfels.count});
  commands.dispatchLinear(surfels.count);
  commands.endPass();
}

void PaintPass::overFragments(gpu::CommandList& commands, SceneTables& tables,
                              OpaqueTables& textures, bool carried,
                              const SeenSurfaces& seen) const {
  commands.beginPass("paint");
  dispatchParts(commands, seen.surfaces, fragments_,
                {.listedPlaces = listedPlaces(seen, nearest_),
                 .surfaceMaterials = surfaceMaterials(textures),
                 .exitances = seen.surfaces.light,
                 .objects = tables.objects,
                 .media = tables.media,
                 .paintTables = tables.paint.entries,
                 .paint = seen.surfaces.paint},
                {.first = 0, .carried = carried});
  commands.endPass();
}

}  // namespace opaline::passes
