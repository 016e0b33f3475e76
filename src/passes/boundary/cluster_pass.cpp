#include "passes/boundary/cluster_pass.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "gpu/device.h"
#include "gpu/transfer.h"
#include "passes/mechanics.h"
#include "shaders/shaders.h"
#include "shaders/shared/boundary.h"
#include "shaders/shared/frame.h"

namespace opaline::passes {

namespace {

using gpu::Binding;
using gpu::BindingType;

// Rays of a cluster that ask what it sees.
constexpr std::uint32_t raysOutwards = 24;

constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

struct ClusterCounts {
  std::uint32_t clusters;
  std::uint32_t piecesPerSurfel;
};

struct EncloseConstants {
  std::uint32_t clusters;
  float openingAngle;
};

struct SurveyCounts {
  std::uint32_t clusters;
  std::uint32_t piecesPerSurfel;
  std::uint32_t raysOutwards;
  std::uint32_t surfelNodes;
};

std::vector<std::uint32_t> leafOfCluster(const surfels::ClusterDivision& made) {
  std::vector<std::uint32_t> leaf(made.count());
  for (std::uint32_t node = 0; node < made.tree.links.size(); ++node) {
    const surfels::NodeLink link = surfels::linkOf(made.tree, node);
    if (link.leaf) leaf[link.first] = node;
  }
  return leaf;
}

std::vector<shared::ClusterRange> rangesOf(const surfels::ClusterDivision& made,
                                           const core::RestSurface& surface,
                                           const surfels::SurfelDivision& surfels,
                                           const std::vector<bool>& triangleHasInside) {
  const auto hasInside = [&](const surfels::Piece& piece) {
    return triangleHasInside[piece.triangle];
  };
  const std::vector<std::uint32_t> leaf = leafOfCluster(made);
  const std::size_t perSurfel = surfels.piecesPerSurfel;
  std::vector<shared::ClusterRange> ranges;
  for (std::uint32_t i = 0; i < made.count(); ++i) {
    const std::uint32_t first = made.firstSurfel[i];
    const std::uint32_t end = made.firstSurfel[i + 1];
    const std::span<const surfels::Piece> pieces =
        std::span(surfels.pieces).subspan(first * perSurfel, (end - first) * perSurfel);
    const bool inside = std::all_of(pieces.begin(), pieces.end(), hasInside);
    ranges.push_back(
        {first, end, surface.objectOfTriangle[pieces.front().triangle], leaf[i], inside ? 1U : 0U});
  }
  return ranges;
}

std::vector<std::uint32_t> clusterOfSurfel(const surfels::ClusterDivision& made) {
  std::vector<std::uint32_t> cluster(made.firstSurfel.back());
  for (std::uint32_t i = 0; i < made.count(); ++i)
    for (std::uint32_t s = made.firstSurfel[i]; s < made.firstSurfel[i + 1]; ++s) cluster[s] = i;
  return cluster;
}

Beams makeBeams(gpu::Device& device, const char* points, const char* strengths,
                std::uint32_t clusters) {
  return {makeRoom<shared::BeamPoint>(device, points, std::size_t{shared::maxPoints} * clusters),
          makeRoom<shared::vec4>(device, strengths, clusters)};
}

}  // namespace

ClusterPass::ClusterPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      linear_(device, gpu::Filter::Linear),
      gather_(device,
              gpu::ComputePipelineOptions{
                  .name = "clusters",
                  .shader = shaders::boundary_clusters_comp,
                  .bindings = {{0, BindingType::UniformBuffer},
                               {1, BindingType::StorageBuffer},
                               {2, BindingType::StorageBuffer},
                               {3, BindingType::StorageBuffer},
                               {4, BindingType::StorageBuffer},
                               {5, BindingType::StorageBuffer},
                               {6, BindingType::SampledImage},
                               {7, BindingType::SampledImage},
                               {8, BindingType::StorageBuffer},
                               {9, BindingType::StorageBuffer},
                               {10, BindingType::StorageBuffer},
                               {11, BindingType::StorageBuffer}},
                  .pushConstantBytes = sizeof(ClusterCounts),
              }),
      nodes_(device, gpu::ComputePipelineOptions{.name = "nodes of clusters",
                                                 .shader = shaders::boundary_cluster_nodes_comp,
                                                 .bindings = slots(3),
                                                 .pushConstantBytes = sizeof(NodeRange)}),
      enclose_(device, gpu::ComputePipelineOptions{.name = "solid angles of clusters",
                                                   .shader = shaders::boundary_enclose_comp,
                                                   .bindings = slots(5, {4}),
                                                   .pushConstantBytes = sizeof(EncloseConstants)}),
      survey_(device,
              gpu::ComputePipelineOptions{.name = "rays of clusters",
                                          .shader = device.hasRayQueries()
                                                        ? shaders::boundary_survey_ray_queries_comp
                                                        : shaders::boundary_survey_comp,
                                          .bindings = {{0, BindingType::StorageBuffer},
                                                       {1, BindingType::StorageBuffer},
                                                       {2, BindingType::TexelBuffer},
                                                       raysSlot(device, 3),
                                                       {4, BindingType::StorageBuffer},
                                                       {5, BindingType::StorageBuffer},
                                                       {6, BindingType::StorageBuffer},
                                                       {7, BindingType::StorageBuffer}},
                                          .pushConstantBytes = sizeof(SurveyCounts)}) {}

Clusters ClusterPass::makeClusters(gpu::Device& device, const surfels::ClusterDivision& made,
                                   const core::RestSurface& surface,
                                   const surfels::SurfelDivision& surfels,
                                   const std::vector<bool>& triangleHasInside) {
  const std::size_t count = made.count();
  const std::size_t nodes = made.tree.links.size();
  Clusters clusters;
  clusters.count = made.count();
  clusters.raysOutwards = raysOutwards;
  clusters.surfelNodes = static_cast<std::uint32_t>(surfels.tree.links.size());
  clusters.firstOfHeight = made.tree.firstOfHeight;
  clusters.ranges = gpu::makeBuffer(device, "ranges of clusters",
                                    rangesOf(made, surface, surfels, triangleHasInside), storage);
  clusters.clusterOfSurfel =
      gpu::makeBuffer(device, "cluster of each surfel", clusterOfSurfel(made), storage);
  clusters.links = gpu::makeBuffer(device, "links of clusters", made.tree.links, storage);
  clusters.byHeight = gpu::makeBuffer(device, "clusters by height", made.tree.byHeight, storage);
  clusters.clusters = makeRoom<shared::Cluster>(device, "clusters", count);
  clusters.nodes = makeRoom<shared::ClusterNode>(device, "tree of clusters", nodes);
  clusters.entries = makeRoom<shared::Entry>(device, "light that enters",
                                             count * (shared::maxLights + std::size_t{1}));
  clusters.meetings = makeRoom<shared::Meeting>(device, "meetings", count * raysOutwards);
  clusters.fromLight =
      makeBeams(device, "points from a light", "strengths from a light", clusters.count);
  clusters.fromEverywhere =
      makeBeams(device, "points from everywhere", "strengths from everywhere", clusters.count);
  clusters.mirrored = makeRoom<shared::Mirrored>(device, "mirrored light", count);
  clusters.peak = makeRoom<shared::vec4>(device, "peak of mirrored light", 1);
  clusters.sums = makeRoom<shared::vec4>(device, "sums of mirrored light", count);
  clusters.arrived = makeRoom<shared::vec4>(device, "arrived mirrored light", count);
  clusters.beamNodes = makeRoom<shared::BeamNode>(device, "tree of points", nodes);
  clusters.sources = makeRoom<shared::vec4>(device, "sources of fluence", count);
  clusters.fluences = makeRoom<shared::vec4>(device, "fluences", count);
  clusters.latest = makeRoom<shared::vec4>(device, "latest exitances", count);
  clusters.exitances = makeRoom<shared::vec4>(device, "exitances of clusters", count);
  clusters.means = makeRoom<shared::vec4>(device, "means over clusters", count);
  clusters.exitancesOfSurfels =
      makeRoom<shared::vec4>(device, "exitances of surfels", surfels.count());
  return clusters;
}

void ClusterPass::record(gpu::CommandList& commands, const Inputs& inputs, bool looksAround,
                         Clusters& clusters) const {
  commands.beginPass("clusters");
  gather(commands, inputs, clusters);
  fitNodes(commands, clusters);
  enclose(commands, inputs, clusters);
  commands.endPass();
  commands.beginPass("rays");
  survey(commands, inputs, looksAround, clusters);
  commands.endPass();
}

void ClusterPass::gather(gpu::CommandList& commands, const Inputs& inputs,
                         Clusters& clusters) const {
  commands.bind(gather_);
  commands.bindResources(
      {Binding::uniform(0, inputs.frame.data), Binding::read(1, inputs.mesh.positions),
       Binding::read(2, inputs.mesh.normals), Binding::read(3, inputs.surfels.pieces),
       Binding::read(4, inputs.tables.objects), Binding::read(5, inputs.tables.media),
       Binding::sampled(6, inputs.shadows.depth, nearest_),
       Binding::sampled(7, inputs.tables.ambientCubes, linear_), Binding::read(8, clusters.ranges),
       Binding::write(9, clusters.clusters), Binding::write(10, clusters.nodes),
       Binding::write(11, clusters.entries)});
  commands.pushConstants(ClusterCounts{clusters.count, inputs.surfels.piecesPerSurfel});
  commands.dispatchLinear(clusters.count);
}

void ClusterPass::fitNodes(gpu::CommandList& commands, Clusters& clusters) const {
  commands.bind(nodes_);
  forEachHeight(clusters.firstOfHeight, [&](std::size_t height, const NodeRange& range) {
    if (height == 0) return;  // clusters, which are there
    commands.bindResources({Binding::read(0, clusters.links), Binding::read(1, clusters.byHeight),
                            Binding::write(2, clusters.nodes)});
    commands.pushConstants(range);
    commands.dispatchLinear(range.count);
  });
}

void ClusterPass::enclose(gpu::CommandList& commands, const Inputs& inputs,
                          Clusters& clusters) const {
  commands.bind(enclose_);
  commands.bindResources({Binding::read(0, inputs.tables.objects),
                          Binding::read(1, inputs.tables.media), Binding::read(2, clusters.ranges),
                          Binding::write(3, clusters.clusters),
                          Binding::texels(4, clusters.nodes)});
  commands.pushConstants(EncloseConstants{clusters.count, inputs.openingAngle});
  commands.dispatchLinear(clusters.count);
}

void ClusterPass::survey(gpu::CommandList& commands, const Inputs& inputs, bool looksAround,
                         Clusters& clusters) const {
  commands.bind(survey_);
  commands.bindResources(
      {Binding::read(0, inputs.tables.objects), Binding::read(1, inputs.tables.media),
       Binding::texels(2, inputs.rays.corners), rays(3, inputs.rays),
       Binding::read(4, clusters.ranges), Binding::write(5, clusters.clusters),
       Binding::read(6, clusters.clusterOfSurfel), Binding::write(7, clusters.meetings)});
  commands.pushConstants(SurveyCounts{clusters.count, inputs.surfels.piecesPerSurfel,
                                      looksAround ? clusters.raysOutwards : 0,
                                      clusters.surfelNodes});
  commands.dispatchLinear(clusters.count);
}

}  // namespace opaline::passes
