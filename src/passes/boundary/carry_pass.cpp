#include "passes/boundary/carry_pass.h"

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/seen_parts.h"

namespace opaline::passes {

CarryPass::CarryPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      meansOfVertices_(device, "means over clusters", {.ofVertices = 1}),
      meansOfSurfels_(device, "means over clusters", {.ofVertices = 0}),
      vertices_(device, "clusters to vertices"),
      fragments_{{device, "clusters to fragments", {.withPaint = 0}},
                 {device, "clusters to fragments", {.withPaint = 1}}} {}

void CarryPass::recordMeans(gpu::CommandList& commands, From from, gpu::Buffer& exitances,
                            Surfels& surfels, Clusters& clusters) const {
  commands.beginPass("carry");
  commands.bind(from == From::Vertices ? meansOfVertices_ : meansOfSurfels_,
                {.ranges = clusters.ranges,
                 .pieces = surfels.pieces,
                 .sources = surfels.sources,
                 .exitances = exitances,
                 .means = clusters.means},
                {.clusterCount = clusters.count, .piecesPerSurfel = surfels.piecesPerSurfel});
  commands.dispatchLinear(clusters.count);
  commands.endPass();
}

void CarryPass::overVertices(gpu::CommandList& commands, ScatterSite site, SceneTables& tables,
                             Clusters& clusters, const Places& vertices) const {
  commands.beginPass("carry");
  commands.bind(vertices_,
                {.objects = tables.objects,
                 .media = tables.media,
                 .clusters = clusters.clusters,
                 .clusterNodes = clusters.nodes,
                 .exitances = clusters.exitances,
                 .means = clusters.means,
                 .positions = vertices.positions,
                 .normals = vertices.normals,
                 .objectOf = vertices.objectOf,
                 .order = vertices.order,
                 .vertexExitances = vertices.exitances},
                {.vertexCount = vertices.count, .site = site});
  commands.dispatchLinear(vertices.count, roundsOfWalk);
  commands.endPass();
}

void CarryPass::overFragments(gpu::CommandList& commands, SceneTables& tables, Clusters& clusters,
                              const SeenSurfaces& seen) const {
  commands.beginPass("carry");
  dispatchAsked(commands, seen.surfaces, fragments_.of(tables.paint.any),
                {.listedPlaces = listedPlaces(seen, nearest_),
                 .media = tables.media,
                 .clusters = clusters.clusters,
                 .clusterNodes = clusters.nodes,
                 .exitances = clusters.exitances,
                 .means = clusters.means,
                 .objects = tables.objects,
                 .found = seen.surfaces.light,
                 .materials = seen.surfaces.materials,
                 .bareLights = clusters.bareLights,
                 .paint = seen.surfaces.paint,
                 .asked = seen.surfaces.asked,
                 .askedCount = seen.surfaces.askedCounts},
                {.first = 0});
  commands.endPass();
}

}  // namespace opaline::passes
