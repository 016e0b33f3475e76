#include "passes/shade/shade_pass.h"

#include "gpu/device.h"
#include "shaders/shared/frame.h"

namespace opaline::passes {

ShadePass::ShadePass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      linear_(device, gpu::Filter::Linear),
      pipeline_(device, "shade") {}

gpu::GpuImage ShadePass::makeRadiance(gpu::Device& device, std::uint32_t width,
                                      std::uint32_t height) {
  return {device,
          {.name = "radiance",
           .width = width,
           .height = height,
           .format = VK_FORMAT_R32G32B32A32_SFLOAT,
           .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                    VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
           .lent = true}};
}

void ShadePass::record(gpu::CommandList& commands, const Inputs& inputs,
                       gpu::GpuImage& radiance) const {
  commands.beginPass("shade");
  commands.bind(pipeline_,
                {.frame = inputs.frame.data,
                 .surfacePosition = {inputs.surface.position, nearest_},
                 .surfaceNormal = {inputs.surface.normal, nearest_},
                 .surfaceExitance = {inputs.exitance, nearest_},
                 .objects = inputs.tables.objects,
                 .media = inputs.tables.media,
                 .shadowMaps = {inputs.shadows.depth, nearest_},
                 .skyReflection = {inputs.sky.reflected, linear_},
                 .specularAlbedo = inputs.tables.specularAlbedo,
                 .radiance = radiance,
                 .skyShare = {inputs.reflectedSky.share, nearest_}},
                {.samplesBefore = inputs.sample,
                 .sampleWeight = 1.0F / static_cast<float>(inputs.samples),
                 .alpha = inputs.roughness * inputs.roughness,
                 .specular = inputs.specular,
                 .skyIsMirrored = inputs.mirrorsSky});
  commands.dispatchTiles(radiance, shared::maxLights);
  commands.endPass();
}

}  // namespace opaline::passes
