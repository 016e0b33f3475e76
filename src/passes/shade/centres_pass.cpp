#include "passes/shade/centres_pass.h"

#include "gpu/device.h"
#include "passes/seen_parts.h"

namespace opaline::passes {

CentresPass::CentresPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest), pipeline_(device, "centres of pixels") {}

SeenCentres CentresPass::makeCentres(gpu::Device& device, VkExtent2D extent) {
  const auto image = [&](const char* name, VkFormat format) {
    return gpu::GpuImage(
        device, {.name = name,
                 .width = extent.width,
                 .height = extent.height,
                 .format = format,
                 .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                          VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
  };
  return {image("seen position", VK_FORMAT_R32G32B32A32_SFLOAT),
          image("seen normal", VK_FORMAT_R16G16B16A16_SFLOAT),
          image("seen exitance", VK_FORMAT_R32G32B32A32_SFLOAT)};
}

void CentresPass::record(gpu::CommandList& commands, const SeenSurfaces& seen, SceneTables& tables,
                         Exitance& exitance, bool atFragments, SeenCentres& centres) const {
  VisibleSurfaces& surfaces = seen.surfaces;
  commands.beginPass("surface");
  dispatchWhole(commands, surfaces.counts, pipeline_,
                {.listedPlaces = listedPlaces(seen, nearest_),
                 .meshExitances = exitance.vertices,
                 .positionObject = centres.position,
                 .unitNormal = centres.normal,
                 .exitance = centres.exitance,
                 .light = surfaces.light,
                 .objects = tables.objects,
                 .materials = surfaces.materials},
                {.atFragments = atFragments, .vertexCount = seen.mesh.vertexCount});
  commands.endPass();
}

}  // namespace opaline::passes
