#include "passes/shade/variable_pass.h"

#include "gpu/device.h"

namespace opaline::passes {

VariablePass::VariablePass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest), pipeline_(device, "variable for others") {}

gpu::GpuImage VariablePass::makeImage(gpu::Device& device, VkExtent2D extent) {
  return {device,
          {.name = "variable for others",
           .width = extent.width,
           .height = extent.height,
           .format = VK_FORMAT_R32G32B32A32_SFLOAT,
           .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                    VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
           .lent = true}};
}

void VariablePass::record(gpu::CommandList& commands, const Inputs& inputs,
                          gpu::GpuImage& variable) const {
  commands.beginPass("variable");
  commands.bind(pipeline_,
                {.places = inputs.centres.position,
                 .values = {inputs.values, nearest_},
                 .variable = variable},
                {.depth = inputs.depth, .origin = inputs.origin, .kind = inputs.kind});
  commands.dispatchTiles(variable);
  commands.endPass();
}

}  // namespace opaline::passes
