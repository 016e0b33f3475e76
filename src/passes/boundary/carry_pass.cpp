#include "passes/boundary/carry_pass.h"

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "shaders/shaders.h"

namespace opaline::passes {

namespace {

using gpu::Binding;
using gpu::BindingType;

struct MeanCounts {
  std::uint32_t clusters;
  std::uint32_t piecesPerSurfel;
};

struct CarryConstants {
  std::uint32_t vertexCount;
  ScatterSite site;
};

gpu::Pipeline makeMeans(gpu::Device& device, bool vertices) {
  return {device, gpu::ComputePipelineOptions{.name = "means over clusters",
                                              .shader = shaders::boundary_means_comp,
                                              .bindings = slots(5),
                                              .pushConstantBytes = sizeof(MeanCounts),
                                              .specialization = {vertices ? 1U : 0U}}};
}

}  // namespace

CarryPass::CarryPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      meansOfVertices_(makeMeans(device, true)),
      meansOfSurfels_(makeMeans(device, false)),
      vertices_(device, gpu::ComputePipelineOptions{.name = "clusters to vertices",
                                                    .shader = shaders::boundary_carry_vertices_comp,
                                                    .bindings = slots(11, {3}),
                                                    .pushConstantBytes = sizeof(CarryConstants)}),
      fragments_(device, gpu::ComputePipelineOptions{
                             .name = "clusters to fragments",
                             .shader = shaders::boundary_carry_fragments_comp,
                             .bindings = {{0, BindingType::StorageBuffer},
                                          {1, BindingType::StorageBuffer},
                                          {2, BindingType::StorageBuffer},
                                          {3, BindingType::TexelBuffer},
                                          {4, BindingType::StorageBuffer},
                                          {5, BindingType::StorageBuffer},
                                          {6, BindingType::SampledImage},
                                          {7, BindingType::SampledImage},
                                          {8, BindingType::StorageImage}},
                             .pushConstantBytes = sizeof(ScatterSite),
                         }) {}

void CarryPass::recordMeans(gpu::CommandList& commands, From from, gpu::Buffer& exitances,
                            Surfels& surfels, Clusters& clusters) const {
  commands.beginPass("carry");
  commands.bind(from == From::Vertices ? meansOfVertices_ : meansOfSurfels_);
  commands.bindResources({Binding::read(0, clusters.ranges), Binding::read(1, surfels.pieces),
                          Binding::read(2, surfels.sources), Binding::read(3, exitances),
                          Binding::write(4, clusters.means)});
  commands.pushConstants(MeanCounts{clusters.count, surfels.piecesPerSurfel});
  commands.dispatchLinear(clusters.count);
  commands.endPass();
}

void CarryPass::overVertices(gpu::CommandList& commands, ScatterSite site, SceneTables& tables,
                             Clusters& clusters, const Places& vertices) const {
  commands.beginPass("carry");
  commands.bind(vertices_);
  commands.bindResources({Binding::read(0, tables.objects), Binding::read(1, tables.media),
                          Binding::read(2, clusters.clusters), Binding::texels(3, clusters.nodes),
                          Binding::read(4, clusters.exitances), Binding::read(5, clusters.means),
                          Binding::read(6, vertices.positions), Binding::read(7, vertices.normals),
                          Binding::read(8, vertices.corners), Binding::read(9, vertices.order),
                          Binding::write(10, vertices.exitances)});
  commands.pushConstants(CarryConstants{vertices.count, site});
  commands.dispatchLinear(vertices.count);
  commands.endPass();
}

void CarryPass::overFragments(gpu::CommandList& commands, ScatterSite site, SceneTables& tables,
                              Clusters& clusters, VisibleSurface& surface,
                              Exitance& exitance) const {
  commands.beginPass("carry");
  commands.bind(fragments_);
  commands.bindResources({Binding::read(0, tables.objects), Binding::read(1, tables.media),
                          Binding::read(2, clusters.clusters), Binding::texels(3, clusters.nodes),
                          Binding::read(4, clusters.exitances), Binding::read(5, clusters.means),
                          Binding::sampled(6, surface.position, nearest_),
                          Binding::sampled(7, surface.normal, nearest_),
                          Binding::writeImage(8, exitance.image)});
  commands.pushConstants(site);
  commands.dispatchTiles(exitance.image);
  commands.endPass();
}

}  // namespace opaline::passes
