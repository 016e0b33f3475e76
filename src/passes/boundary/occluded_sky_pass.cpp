#include "passes/boundary/occluded_sky_pass.h"

#include "gpu/device.h"
#include "passes/mechanics.h"

namespace opaline::passes {

OccludedSkyPass::OccludedSkyPass(gpu::Device& device)
    : linear_(device, gpu::Filter::Linear), pass_(device, "sky on surfels") {}

void OccludedSkyPass::record(gpu::CommandList& commands, SceneTables& tables, Sky& sky,
                             Clusters& clusters, Surfels& surfels) const {
  commands.beginPass("sky");
  commands.bind(pass_,
                {.objects = tables.objects,
                 .media = tables.media,
                 .clusterNodes = clusters.nodes,
                 .skyIrradiance = {sky.irradiance, linear_},
                 .ranges = clusters.ranges,
                 .clusterTexels = clusters.clusters,
                 .skyShares = clusters.skyShares,
                 .surfelNormals = surfels.normals,
                 .places = surfels.places,
                 .sources = surfels.sources,
                 .sharesOfSurfels = surfels.skyShares,
                 .around = clusters.around},
                {.clusterCount = clusters.count});
  commands.dispatchGroups(clusters.count * clusters.partsOfSurfels, shared::roomOfAround);
  commands.endPass();
}

}  // namespace opaline::passes
