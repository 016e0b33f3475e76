#include "passes/shade/seen_surfels_pass.h"

#include "gpu/device.h"
#include "shaders/shaders.h"

namespace opaline::passes {

namespace {

using gpu::Binding;
using gpu::BindingType;

struct SeenConstants {
  std::uint32_t treeLevel;
  std::uint32_t hasClusters;
};

}  // namespace

SeenSurfelsPass::SeenSurfelsPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      pipeline_(device, gpu::ComputePipelineOptions{
                            .name = "seen surfels",
                            .shader = shaders::shade_seen_surfels_comp,
                            .bindings = {{0, BindingType::SampledImage},
                                         {1, BindingType::StorageImage},
                                         {2, BindingType::StorageBuffer},
                                         {3, BindingType::TexelBuffer},
                                         {4, BindingType::TexelBuffer},
                                         {5, BindingType::StorageBuffer}},
                            .pushConstantBytes = sizeof(SeenConstants),
                        }) {}

SeenSurfels SeenSurfelsPass::makeSeen(gpu::Device& device, const VisibleSurface& surface) {
  const VkExtent2D extent = surface.position.extent();
  return {gpu::GpuImage(device,
                        {.name = "seen surfels",
                         .width = extent.width,
                         .height = extent.height,
                         .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                         .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT})};
}

void SeenSurfelsPass::record(gpu::CommandList& commands, const Inputs& inputs,
                             SeenSurfels& seen) const {
  const bool clusters = inputs.clusters != nullptr;
  commands.beginPass("seen surfels");
  commands.bind(pipeline_);
  commands.bindResources(
      {Binding::sampled(0, inputs.surface.position, nearest_), Binding::writeImage(1, seen.image),
       Binding::read(2, inputs.tables.objects), Binding::texels(3, inputs.rays.corners),
       Binding::texels(4, inputs.rays.boxes),
       Binding::read(5, clusters ? inputs.clusters->clusterOfSurfel : inputs.surfels.order)});
  commands.pushConstants(SeenConstants{inputs.treeLevel, clusters ? 1U : 0U});
  commands.dispatchTiles(seen.image);
  commands.endPass();
}

}  // namespace opaline::passes
