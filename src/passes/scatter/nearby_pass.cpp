#include "passes/scatter/nearby_pass.h"

#include <vector>

#include "gpu/device.h"
#include "shaders/shaders.h"

namespace opaline::passes {

namespace {

using gpu::Binding;
using gpu::BindingSlot;
using gpu::BindingType;

struct NearbyConstants {
  std::uint32_t vertexCount;
  ScatterSite site;
};

// What both read beside the places that they correct.
std::vector<BindingSlot> withShared(std::vector<BindingSlot> slots) {
  for (const BindingSlot& slot : {BindingSlot{0, BindingType::UniformBuffer},
                                  {4, BindingType::StorageBuffer},
                                  {5, BindingType::StorageBuffer},
                                  {6, BindingType::SampledImage},
                                  {7, BindingType::SampledImage},
                                  {8, BindingType::TexelBuffer},
                                  {9, BindingType::TexelBuffer},
                                  {10, BindingType::StorageBuffer}})
    slots.push_back(slot);
  return slots;
}

}  // namespace

NearbyPass::NearbyPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      linear_(device, gpu::Filter::Linear),
      dipole_(makePipelines(device, ScatterTransport::Dipole)),
      betterDipole_(makePipelines(device, ScatterTransport::BetterDipole)) {}

NearbyPass::Pipelines NearbyPass::makePipelines(gpu::Device& device, ScatterTransport transport) {
  const std::vector<std::uint32_t> specialization{static_cast<std::uint32_t>(transport)};
  return {gpu::Pipeline(device,
                        gpu::ComputePipelineOptions{
                            .name = "nearby over vertices",
                            .shader = shaders::scatter_nearby_vertices_comp,
                            .bindings = withShared({{1, BindingType::StorageBuffer},
                                                    {2, BindingType::StorageBuffer},
                                                    {3, BindingType::StorageBuffer},
                                                    {11, BindingType::StorageBuffer},
                                                    {12, BindingType::StorageBuffer}}),
                            .pushConstantBytes = sizeof(NearbyConstants),
                            .specialization = specialization,
                        }),
          gpu::Pipeline(device, gpu::ComputePipelineOptions{
                                    .name = "nearby over fragments",
                                    .shader = shaders::scatter_nearby_comp,
                                    .bindings = withShared({{1, BindingType::SampledImage},
                                                            {2, BindingType::StorageImage},
                                                            {3, BindingType::SampledImage}}),
                                    .pushConstantBytes = sizeof(ScatterSite),
                                    .specialization = specialization,
                                })};
}

void NearbyPass::overPlaces(gpu::CommandList& commands, ScatterTransport transport,
                            ScatterSite site, const Inputs& inputs, const Places& places) const {
  commands.beginPass("nearby");
  commands.bind(pipelines(transport).vertices);
  commands.bindResources(
      {Binding::uniform(0, inputs.frame.data), Binding::read(1, places.positions),
       Binding::read(2, places.corners), Binding::write(3, places.exitances),
       Binding::read(4, inputs.tables.objects), Binding::read(5, inputs.tables.media),
       Binding::sampled(6, inputs.shadows.depth, nearest_),
       Binding::sampled(7, inputs.tables.ambientCubes, linear_),
       Binding::texels(8, inputs.surfels.nodes), Binding::texels(9, inputs.surfels.sources),
       Binding::read(10, inputs.surfels.normals), Binding::read(11, places.normals),
       Binding::read(12, places.order)});
  commands.pushConstants(NearbyConstants{places.count, site});
  commands.dispatchLinear(places.count);
  commands.endPass();
}

void NearbyPass::overFragments(gpu::CommandList& commands, ScatterTransport transport,
                               ScatterSite site, const Inputs& inputs, VisibleSurface& surface,
                               Exitance& exitance) const {
  commands.beginPass("nearby");
  commands.bind(pipelines(transport).fragments);
  commands.bindResources(
      {Binding::uniform(0, inputs.frame.data), Binding::sampled(1, surface.position, nearest_),
       Binding::writeImage(2, exitance.image), Binding::sampled(3, surface.normal, nearest_),
       Binding::read(4, inputs.tables.objects), Binding::read(5, inputs.tables.media),
       Binding::sampled(6, inputs.shadows.depth, nearest_),
       Binding::sampled(7, inputs.tables.ambientCubes, linear_),
       Binding::texels(8, inputs.surfels.nodes), Binding::texels(9, inputs.surfels.sources),
       Binding::read(10, inputs.surfels.normals)});
  commands.pushConstants(site);
  commands.dispatchTiles(exitance.image);
  commands.endPass();
}

}  // namespace opaline::passes
