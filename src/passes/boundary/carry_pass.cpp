#include "passes/boundary/carry_pass.h"

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/seen_parts.h"

namespace opaline::passes {

CarryPass::CarryPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      patches_(device, "patches of clusters"),
      means_{
          {{device, "means over clusters", {.from = static_cast<std::uint32_t>(From::Vertices)}},
           {device, "means over clusters", {.from = static_cast<std::uint32_t>(From::Surfels)}},
           {device, "means over clusters", {.from = static_cast<std::uint32_t>(From::Patches)}}}},
      vertices_(device, "clusters to vertices"),
      fragments_{{device, "clusters to fragments", {.withPaint = 0}},
                 {device, "clusters to fragments", {.withPaint = 1}}} {}

void CarryPass::recordPatches(gpu::CommandList& commands, Surfels& surfels,
                              Clusters& clusters) const {
  commands.beginPass("carry");
  commands.bind(patches_,
                {.ranges = clusters.ranges,
                 .sources = surfels.sources,
                 .places = surfels.places,
                 .patches = clusters.patches},
                {.clusterCount = clusters.count});
  commands.dispatchLinear(clusters.count);
  commands.endPass();
}

void CarryPass::recordMeans(gpu::CommandList& commands, From from, gpu::Buffer& exitances,
                            Surfels& surfels, Clusters& clusters) const {
  commands.beginPass("carry");
  commands.bind(means_[static_cast<std::size_t>(from)],
                {.ranges = clusters.ranges,
                 .pieces = surfels.pieces,
                 .sources = surfels.sources,
                 .exitances = exitances,
                 .means = clusters.means,
                 .patches = clusters.patches},
                {.clusterCount = clusters.count, .piecesPerSurfel = surfels.piecesPerSurfel});
  commands.dispatchLinear(clusters.count);
  commands.endPass();
}

void CarryPass::overVertices(gpu::CommandList& commands, ScatterSite site, SceneTables& tables,
                             Clusters& clusters, const Places& vertices,
                             gpu::Buffer& origins) const {
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
                 .vertexExitances = vertices.exitances,
                 .origins = origins,
                 .nearby = clusters.nearby},
                {.vertexCount = vertices.count, .sides = tables.sidesOfVertices(), .site = site});
  commands.dispatchLinear(tables.sidesOfVertices() * vertices.count, roundsOfWalk);
  commands.endPass();
}

void CarryPass::overFragments(gpu::CommandList& commands, SceneTables& tables, Clusters& clusters,
                              Asked asked, const SeenSurfaces& seen) const {
  commands.beginPass("carry");
  dispatchAsked(commands, seen.surfaces, asked, fragments_.of(tables.paint.any),
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
                 .askedCount = seen.surfaces.countsOf(asked),
                 .origins = seen.surfaces.origins,
                 .nearby = clusters.nearby},
                {.first = 0, .keepsOrigins = seen.surfaces.kept.origins});
  commands.endPass();
}

}  // namespace opaline::passes
