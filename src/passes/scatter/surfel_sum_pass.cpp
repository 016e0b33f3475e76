#include "passes/scatter/surfel_sum_pass.h"

#include <algorithm>
#include <string>
#include <vector>

#include "gpu/device.h"
#include "shaders/shaders.h"

namespace opaline::passes {

namespace {

using gpu::Binding;
using gpu::BindingType;

// Surfels summed by one dispatch, so that none runs into the time limit of a display's device.
constexpr std::uint32_t surfelsPerDispatch = 8192;

struct SurfelRange {
  std::uint32_t first;
  std::uint32_t end;
  ScatterSite site;
};

struct VertexSurfelRange {
  std::uint32_t vertexCount;
  SurfelRange range;
};

struct TreeConstants {
  float tolerance;
  ScatterSite site;
};

struct VertexTreeConstants {
  std::uint32_t vertexCount;
  TreeConstants tree;
};

template <typename Dispatch>
void forEachRange(std::uint32_t surfels, ScatterSite site, const Dispatch& dispatch) {
  std::uint32_t first = 0;
  do {
    const std::uint32_t end = first + std::min(surfelsPerDispatch, surfels - first);
    dispatch(SurfelRange{first, end, site});
    first = end;
  } while (first < surfels);
}

gpu::Pipeline makeTreeVertices(gpu::Device& device, ScatterTransport transport, bool rough) {
  return {device, gpu::ComputePipelineOptions{
                      .name = rough ? "rough sum over vertices" : "tree over vertices",
                      .shader = shaders::scatter_tree_vertices_comp,
                      .bindings = {{1, BindingType::StorageBuffer},
                                   {2, BindingType::StorageBuffer},
                                   {3, BindingType::StorageBuffer},
                                   {4, BindingType::StorageBuffer},
                                   {5, BindingType::StorageBuffer},
                                   {6, BindingType::TexelBuffer},
                                   {7, BindingType::TexelBuffer},
                                   {8, BindingType::StorageBuffer}},
                      .pushConstantBytes = sizeof(VertexTreeConstants),
                      .specialization = {static_cast<std::uint32_t>(transport), rough ? 1U : 0U},
                  }};
}

}  // namespace

SurfelSumPass::SurfelSumPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      dipole_(makePipelines(device, ScatterTransport::Dipole)),
      betterDipole_(makePipelines(device, ScatterTransport::BetterDipole)) {}

SurfelSumPass::Pipelines SurfelSumPass::makePipelines(gpu::Device& device,
                                                      ScatterTransport transport) {
  const std::vector<std::uint32_t> specialization{static_cast<std::uint32_t>(transport)};
  return {
      makeTreeVertices(device, transport, true),
      makeTreeVertices(device, transport, false),
      gpu::Pipeline(device,
                    gpu::ComputePipelineOptions{
                        .name = "tree over fragments",
                        .shader = shaders::scatter_tree_comp,
                        .bindings = {{1, BindingType::SampledImage},
                                     {2, BindingType::StorageImage},
                                     {3, BindingType::SampledImage},
                                     {4, BindingType::StorageBuffer},
                                     {5, BindingType::StorageBuffer},
                                     {6, BindingType::TexelBuffer},
                                     {7, BindingType::TexelBuffer}},
                        .pushConstantBytes = sizeof(TreeConstants),
                        .specialization = specialization,
                    }),
      gpu::Pipeline(device,
                    gpu::ComputePipelineOptions{
                        .name = "all surfels over vertices",
                        .shader = shaders::scatter_all_vertices_comp,
                        .bindings = {{1, BindingType::StorageBuffer},
                                     {2, BindingType::StorageBuffer},
                                     {3, BindingType::StorageBuffer},
                                     {4, BindingType::StorageBuffer},
                                     {5, BindingType::StorageBuffer},
                                     {6, BindingType::TexelBuffer}},
                        .pushConstantBytes = sizeof(VertexSurfelRange),
                        .specialization = specialization,
                    }),
      gpu::Pipeline(device,
                    gpu::ComputePipelineOptions{
                        .name = "all surfels over fragments",
                        .shader = shaders::scatter_all_comp,
                        .bindings = {{1, BindingType::SampledImage},
                                     {2, BindingType::StorageImage},
                                     {3, BindingType::SampledImage},
                                     {4, BindingType::StorageBuffer},
                                     {5, BindingType::StorageBuffer},
                                     {6, BindingType::TexelBuffer}},
                        .pushConstantBytes = sizeof(SurfelRange),
                        .specialization = specialization,
                    }),
  };
}

void SurfelSumPass::treeOverPlaces(gpu::CommandList& commands, const Order& order,
                                   const OverPlaces& over) const {
  const Pipelines& made = pipelines(order.transport);
  for (const gpu::Pipeline* pipeline : {&made.roughVertices, &made.treeVertices}) {
    if (pipeline == &made.treeVertices && order.site == ScatterSite::Fragments) break;
    commands.beginPass(pipeline == &made.roughVertices ? "estimate" : "scatter");
    commands.bind(*pipeline);
    commands.bindResources(
        {Binding::read(1, over.places.positions), Binding::read(2, over.places.corners),
         Binding::write(3, over.places.exitances), Binding::read(4, over.tables.objects),
         Binding::read(5, over.tables.media), Binding::texels(6, over.surfels.nodes),
         Binding::texels(7, over.surfels.sources), Binding::read(8, over.places.order)});
    commands.pushConstants(VertexTreeConstants{over.places.count, {order.tolerance, order.site}});
    commands.dispatchLinear(over.places.count);
    commands.endPass();
  }
}

void SurfelSumPass::treeOverFragments(gpu::CommandList& commands, const Order& order,
                                      const Fragments& over) const {
  commands.beginPass("scatter");
  commands.bind(pipelines(order.transport).treeFragments);
  commands.bindResources(
      {Binding::sampled(1, over.surface.position, nearest_),
       Binding::writeImage(2, over.exitance.image),
       Binding::sampled(3, over.surface.exitance, nearest_), Binding::read(4, over.tables.objects),
       Binding::read(5, over.tables.media), Binding::texels(6, over.surfels.nodes),
       Binding::texels(7, over.surfels.sources)});
  commands.pushConstants(TreeConstants{order.tolerance, order.site});
  commands.dispatchTiles(over.exitance.image);
  commands.endPass();
}

void SurfelSumPass::allOverPlaces(gpu::CommandList& commands, const Order& order,
                                  const OverPlaces& over) const {
  commands.beginPass("scatter");
  commands.bind(pipelines(order.transport).allVertices);
  forEachRange(over.surfels.count, order.site, [&](const SurfelRange& range) {
    commands.bindResources(
        {Binding::read(1, over.places.positions), Binding::read(2, over.places.corners),
         Binding::write(3, over.places.exitances), Binding::read(4, over.tables.objects),
         Binding::read(5, over.tables.media), Binding::texels(6, over.surfels.sources)});
    commands.pushConstants(VertexSurfelRange{over.places.count, range});
    commands.dispatchLinear(over.places.count);
  });
  commands.endPass();
}

void SurfelSumPass::allOverFragments(gpu::CommandList& commands, const Order& order,
                                     const Fragments& over) const {
  commands.beginPass("scatter");
  commands.bind(pipelines(order.transport).allFragments);
  forEachRange(over.surfels.count, order.site, [&](const SurfelRange& range) {
    commands.bindResources({Binding::sampled(1, over.surface.position, nearest_),
                            Binding::writeImage(2, over.exitance.image),
                            Binding::sampled(3, over.surface.exitance, nearest_),
                            Binding::read(4, over.tables.objects),
                            Binding::read(5, over.tables.media),
                            Binding::texels(6, over.surfels.sources)});
    commands.pushConstants(range);
    commands.dispatchTiles(over.exitance.image);
  });
  commands.endPass();
}

}  // namespace opaline::passes
