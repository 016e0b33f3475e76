#include "passes/boundary/cluster_pass.h"

#include <algorithm>
#include <cstddef>

#include "gpu/device.h"
#include "passes/fitted_tree.h"
#include "passes/mechanics.h"
#include "shaders/shared/boundary.h"

namespace opaline::passes {

ClusterPass::ClusterPass(gpu::Device& device)
    : linear_(device, gpu::Filter::Linear),
      gather_(device, "clusters"),
      entries_{{{device, "light that enters", {.withAreaLights = 0, .withNormals = 0}},
                {device, "light that enters", {.withAreaLights = 0, .withNormals = 1}}},
               {{device, "light that enters", {.withAreaLights = 1, .withNormals = 0}},
                {device, "light that enters", {.withAreaLights = 1, .withNormals = 1}}}},
      nodes_(device, "nodes of clusters"),
      enclose_(device, "solid angles of clusters"),
      survey_{{{device, "rays of clusters", {.withThinParts = 0, .withPaint = 0}},
               {device, "rays of clusters", {.withThinParts = 0, .withPaint = 1}}},
              {{device, "rays of clusters", {.withThinParts = 1, .withPaint = 0}},
               {device, "rays of clusters", {.withThinParts = 1, .withPaint = 1}}}} {}

void ClusterPass::makeRoomBehind(gpu::Device& device, Clusters& clusters) {
  if (clusters.meetingsBehind) return;
  const std::size_t rays = std::size_t{clusters.count} * clusters.raysOutwards;
  clusters.meetingsBehind = makeRoom<shared::MeetingBehind>(device, "meetings behind thin parts",
                                                            rays * shared::meetingsBehind);
}

void ClusterPass::recordShape(gpu::CommandList& commands, const ShapeInputs& inputs,
                              Clusters& clusters) const {
  commands.beginPass("clusters");
  gather(commands, inputs, clusters);
  fitNodes(commands, clusters);
  enclose(commands, inputs, clusters);
  commands.endPass();
}

void ClusterPass::recordSurvey(gpu::CommandList& commands, const ShapeInputs& inputs,
                               Clusters& clusters) const {
  commands.beginPass("rays");
  survey(commands, inputs, clusters);
  commands.endPass();
}

void ClusterPass::recordEntries(gpu::CommandList& commands, const EntryInputs& inputs,
                                Clusters& clusters) const {
  commands.beginPass("clusters");
  const bool hasNormals = inputs.tables.surfaces.anyNormals;
  commands.bind(entries_.of(inputs.areaLights, hasNormals),
                {.frame = inputs.frame.data,
                 .positions = inputs.mesh.positions,
                 .normals = inputs.mesh.normals,
                 .pieces = inputs.surfels.pieces,
                 .objects = inputs.tables.objects,
                 .media = inputs.tables.media,
                 .visibilities = inputs.surfels.visibilities,
                 .skyIrradiance = {inputs.sky.irradiance, linear_},
                 .ranges = clusters.ranges,
                 .clusters = clusters.clusters,
                 .entries = clusters.entries,
                 .tilts = inputs.tables.surfaces.tilts},
                {.clusterCount = clusters.count,
                 .piecesPerSurfel = inputs.surfels.piecesPerSurfel,
                 .pieceCount = inputs.surfels.count * inputs.surfels.piecesPerSurfel,
                 .skyIsDark = inputs.skyIsDark});
  commands.dispatchLinear((inputs.lights + 1) * clusters.count);
  commands.endPass();
}

void ClusterPass::gather(gpu::CommandList& commands, const ShapeInputs& inputs,
                         Clusters& clusters) const {
  commands.bind(
      gather_,
      {.positions = inputs.mesh.positions,
       .normals = inputs.mesh.normals,
       .pieces = inputs.surfels.pieces,
       .ranges = clusters.ranges,
       .clusters = clusters.clusters,
       .nodes = clusters.nodes},
      {.clusterCount = clusters.count, .piecesPerSurfel = inputs.surfels.piecesPerSurfel});
  commands.dispatchLinear(clusters.count);
}

void ClusterPass::fitNodes(gpu::CommandList& commands, Clusters& clusters) const {
  fitInnerNodes(commands, clusters.tree, [&](std::uint32_t first, std::uint32_t count) {
    commands.bind(nodes_, {.treeletOrder = treeletOrder(clusters.tree), .nodes = clusters.nodes},
                  {.firstTreelet = first, .treeletCount = count});
  });
}

void ClusterPass::enclose(gpu::CommandList& commands, const ShapeInputs& inputs,
                          Clusters& clusters) const {
  commands.bind(enclose_,
                {.objects = inputs.tables.objects,
                 .media = inputs.tables.media,
                 .tiles = clusters.tiles,
                 .clusterTexels = clusters.clusters,
                 .clusterNodes = clusters.nodes,
                 .clusters = clusters.clusters,
                 .lists = clusters.lists,
                 .ranges = clusters.ranges,
                 .around = clusters.around},
                {.tileCount = clusters.tileCount,
                 .openingAngle = inputs.openingAngle,
                 .roomOfList = clusters.roomOfList});
  commands.dispatchGroups(clusters.tileCount, roundsOfWalk);
}

void ClusterPass::survey(gpu::CommandList& commands, const ShapeInputs& inputs,
                         Clusters& clusters) const {
  const bool looksThrough = inputs.looksThrough && inputs.tables.haveThinParts;
  const std::uint32_t all = inputs.looksAround ? clusters.raysOutwards : 0;
  std::uint32_t first = 0;
  do {
    const std::uint32_t end = std::min(first + clusters.raysAtOnce, all);
    commands.bind(survey_.of(looksThrough, looksThrough && inputs.tables.paint.any),
                  {.objects = inputs.tables.objects,
                   .media = inputs.tables.media,
                   .pieceCorners = inputs.rays.corners,
                   .rayHierarchy = rays(inputs.rays),
                   .ranges = clusters.ranges,
                   .clusters = clusters.clusters,
                   .clusterOfSurfel = clusters.clusterOfSurfel,
                   .meetings = clusters.meetings,
                   .skyRadiance = {inputs.sky.radiance, linear_},
                   .skyShares = clusters.skyShares,
                   .brightSky = inputs.sky.bright,
                   .clusterPaints = inputs.tables.paint.clusters,
                   .skySums = clusters.skySums,
                   .clusterNodes = clusters.nodes,
                   .behind = looksThrough ? clusters.meetingsBehind : clusters.meetings,
                   .withheld = clusters.withheld},
                  {.clusterCount = clusters.count,
                   .piecesPerSurfel = inputs.surfels.piecesPerSurfel,
                   .raysOutwards = all,
                   .nodeCount = inputs.surfels.tree.nodeCount,
                   .firstRay = first,
                   .endRay = end});
    commands.dispatchLanes(clusters.count,
                           (end - first + 1 + 2 * shared::placesInwards) * roundsOfWalk);
    first = end;
  } while (first < all);
}

}  // namespace opaline::passes
