#include "passes/scatter/opaque_pass.h"

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/seen_parts.h"

namespace opaline::passes {

OpaquePass::OpaquePass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      clusters_(device, "opaque clusters"),
      vertices_(device, "opaque vertices"),
      fragments_(device, "opaque fragments") {}

void OpaquePass::overClusters(gpu::CommandList& commands, const Inputs& inputs, From from,
                              Clusters& clusters) const {
  commands.beginPass("opaque");
  commands.bind(clusters_,
                {.frame = inputs.frame.data,
                 .objects = inputs.tables.objects,
                 .media = inputs.tables.media,
                 .ranges = clusters.ranges,
                 .clusters = clusters.clusters,
                 .entries = clusters.entries,
                 .skyShares = clusters.skyShares,
                 .entered = clusters.entered,
                 .latest = clusters.latest,
                 .enteredBefore = clusters.enteredBefore,
                 .exitances = clusters.exitances},
                {.clusterCount = clusters.count, .again = from == From::Clusters});
  commands.dispatchLinear(clusters.count);
  commands.endPass();
}

void OpaquePass::overVertices(gpu::CommandList& commands, const Inputs& inputs, ScatterSite site,
                              const Places& vertices) const {
  commands.beginPass("opaque");
  commands.bind(vertices_,
                {.frame = inputs.frame.data,
                 .positions = vertices.positions,
                 .normals = vertices.normals,
                 .objects = inputs.tables.objects,
                 .media = inputs.tables.media,
                 .shadowMaps = {inputs.shadows.depth, nearest_},
                 .objectOf = vertices.objectOf,
                 .exitances = vertices.exitances},
                {.vertexCount = vertices.count, .site = site});
  commands.dispatchLinear(vertices.count);
  commands.endPass();
}

void OpaquePass::overFragments(gpu::CommandList& commands, const Inputs& inputs, ScatterSite site,
                               const SeenSurfaces& seen) const {
  commands.beginPass("opaque");
  dispatchParts(commands, seen.surfaces, fragments_,
                {.listedPlaces = listedPlaces(seen, nearest_),
                 .exitances = seen.surfaces.light,
                 .objects = inputs.tables.objects,
                 .media = inputs.tables.media,
                 .shadowMaps = {inputs.shadows.depth, nearest_}},
                {.first = 0, .site = site});
  commands.endPass();
}

}  // namespace opaline::passes
