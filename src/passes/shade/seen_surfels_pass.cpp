#include "passes/shade/seen_surfels_pass.h"

#include "gpu/device.h"
#include "passes/mechanics.h"

namespace opaline::passes {

SeenSurfelsPass::SeenSurfelsPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest), pipeline_(device, "seen surfels") {}

SeenSurfels SeenSurfelsPass::makeSeen(gpu::Device& device, VkExtent2D extent) {
  return {gpu::GpuImage(device, {.name = "seen surfels",
                                 .width = extent.width,
                                 .height = extent.height,
                                 .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                                 .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                                          VK_IMAGE_USAGE_TRANSFER_SRC_BIT})};
}

void SeenSurfelsPass::record(gpu::CommandList& commands, const Inputs& inputs,
                             SeenSurfels& seen) const {
  const bool clusters = inputs.clusters != nullptr;
  commands.beginPass("seen surfels");
  commands.bind(
      pipeline_,
      {.surfacePosition = {inputs.centres.position, nearest_},
       .seen = seen.image,
       .objects = inputs.tables.objects,
       .pieceCorners = inputs.rays.corners,
       .rayHierarchy = inputs.rays.boxes,
       .clusterOfSurfel = clusters ? inputs.clusters->clusterOfSurfel : inputs.surfels.order},
      {.treeLevel = inputs.treeLevel, .hasClusters = clusters});
  commands.dispatchTiles(seen.image, roundsOfWalk);
  commands.endPass();
}

}  // namespace opaline::passes
