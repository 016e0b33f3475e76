#include "passes/shade/seen_irradiance_pass.h"

#include "gpu/device.h"

namespace opaline::passes {

SeenIrradiancePass::SeenIrradiancePass(gpu::Device& device)
    : pipeline_(device, "seen irradiance") {}

gpu::GpuImage SeenIrradiancePass::makeImage(gpu::Device& device, VkExtent2D extent) {
  return {device,
          {.name = "seen irradiance",
           .width = extent.width,
           .height = extent.height,
           .format = VK_FORMAT_R32G32B32A32_SFLOAT,
           .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                    VK_IMAGE_USAGE_TRANSFER_SRC_BIT}};
}

void SeenIrradiancePass::record(gpu::CommandList& commands, SeenSurfels& seen, Surfels& surfels,
                                gpu::GpuImage& irradiance) const {
  commands.beginPass("seen irradiance");
  commands.bind(pipeline_,
                {.seen = seen.image, .sources = surfels.sources, .irradiance = irradiance});
  commands.dispatchTiles(irradiance);
  commands.endPass();
}

}  // namespace opaline::passes
