#include "passes/shade/compose_pass.h"

#include "gpu/device.h"

namespace opaline::passes {

ComposePass::ComposePass(gpu::Device& device)
    : device_(device), nearest_(device, gpu::Filter::Nearest) {}

const ComposePass::Pipeline& ComposePass::pipelineFor(const Target& target) {
  const VkFormat color = target.color.options().format;
  const VkFormat depth =
      target.depth != nullptr ? target.depth->options().format : VK_FORMAT_UNDEFINED;
  const bool isReversed = target.depth != nullptr && target.how.isReversed;
  for (const Made& made : made_)
    if (made.color == color && made.depth == depth && made.isReversed == isReversed &&
        made.samples == target.samples)
      return *made.pipeline;
  gpu::GraphicsOptions options{.colorFormats = {color},
                               .depthFormat = depth,
                               .blend = gpu::Blend::Over,
                               .samples = target.samples};
  if (target.depth != nullptr)
    options.depth =
        isReversed ? gpu::DepthMode::WriteOrEqual : gpu::DepthMode::WriteOrEqualOrdinary;
  made_.push_back({color, depth, isReversed, target.samples,
                   std::make_unique<const Pipeline>(device_, "compose", options)});
  return *made_.back().pipeline;
}

void ComposePass::record(gpu::CommandList& commands, const SeenSurfaces& seen,
                         gpu::GpuImage& radiance, const Target& target) {
  const Pipeline& pipeline = pipelineFor(target);
  commands.beginPass("compose");
  commands.bind(pipeline, {},
                {.seenPlaces = seenPlaces(seen, nearest_), .radiance = {radiance, nearest_}},
                {.clipDepth = target.how.clipDepth,
                 .clipW = target.how.clipW,
                 .layers = seen.surfaces.words.options().layers,
                 .isReversed = target.how.isReversed ? 1U : 0U,
                 .scale = target.scale});
  const gpu::ColorTarget color{.image = &target.color, .clear = false};
  const gpu::DepthTarget depth{.image = target.depth, .clear = false};
  commands.beginRendering({color}, target.depth != nullptr ? &depth : nullptr);
  commands.draw(3);
  commands.endRendering();
  commands.endPass();
}

}  // namespace opaline::passes
