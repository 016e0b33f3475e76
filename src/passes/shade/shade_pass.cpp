#include "passes/shade/shade_pass.h"

#include "gpu/device.h"
#include "shaders/shaders.h"
#include "shaders/shared/frame.h"

namespace opaline::passes {

namespace {

using gpu::Binding;
using gpu::BindingType;

struct ShadeConstants {
  std::uint32_t samplesBefore;
  float sampleWeight;
  float alpha;
  std::uint32_t specular;
  std::uint32_t skyIsMirrored;
};

}  // namespace

ShadePass::ShadePass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      linear_(device, gpu::Filter::Linear),
      pipeline_(device, gpu::ComputePipelineOptions{
                            .name = "shade",
                            .shader = shaders::shade_shade_comp,
                            .bindings = {{0, BindingType::UniformBuffer},
                                         {1, BindingType::SampledImage},
                                         {2, BindingType::SampledImage},
                                         {3, BindingType::SampledImage},
                                         {4, BindingType::StorageBuffer},
                                         {5, BindingType::StorageBuffer},
                                         {6, BindingType::SampledImage},
                                         {7, BindingType::SampledImage},
                                         {8, BindingType::StorageBuffer},
                                         {9, BindingType::StorageImage},
                                         {10, BindingType::SampledImage}},
                            .pushConstantBytes = sizeof(ShadeConstants),
                        }) {}

gpu::GpuImage ShadePass::makeRadiance(gpu::Device& device, std::uint32_t width,
                                      std::uint32_t height) {
  return {device,
          {.name = "radiance",
           .width = width,
           .height = height,
           .format = VK_FORMAT_R32G32B32A32_SFLOAT,
           .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                    VK_IMAGE_USAGE_TRANSFER_SRC_BIT}};
}

void ShadePass::record(gpu::CommandList& commands, const Inputs& inputs,
                       gpu::GpuImage& radiance) const {
  commands.beginPass("shade");
  commands.bind(pipeline_);
  commands.bindResources(
      {Binding::uniform(0, inputs.frame.data),
       Binding::sampled(1, inputs.surface.position, nearest_),
       Binding::sampled(2, inputs.surface.normal, nearest_),
       Binding::sampled(3, inputs.exitance, nearest_), Binding::read(4, inputs.tables.objects),
       Binding::read(5, inputs.tables.media), Binding::sampled(6, inputs.shadows.depth, nearest_),
       Binding::sampled(7, inputs.environmentCube, linear_),
       Binding::read(8, inputs.tables.specularAlbedo), Binding::writeImage(9, radiance),
       Binding::sampled(10, inputs.sky.share, nearest_)});
  commands.pushConstants(ShadeConstants{.samplesBefore = inputs.sample,
                                        .sampleWeight = 1.0F / static_cast<float>(inputs.samples),
                                        .alpha = inputs.roughness * inputs.roughness,
                                        .specular = inputs.specular ? 1U : 0U,
                                        .skyIsMirrored = inputs.mirrorsSky ? 1U : 0U});
  commands.dispatchTiles(radiance);
  commands.endPass();
}

}  // namespace opaline::passes
