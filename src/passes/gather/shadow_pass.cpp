#include "passes/gather/shadow_pass.h"

#include <algorithm>

#include "gpu/device.h"

namespace opaline::passes {

ShadowPass::ShadowPass(gpu::Device& device)
    : pipeline_(device, "shadow",
                {.depthFormat = VK_FORMAT_D32_SFLOAT, .depth = gpu::DepthMode::Write}) {}

ShadowMaps ShadowPass::makeMaps(gpu::Device& device, std::uint32_t size, std::uint32_t views) {
  return {gpu::GpuImage(
      device, {.name = "shadow maps",
               .width = size,
               .height = size,
               .layers = std::max(views, 1U),
               .format = VK_FORMAT_D32_SFLOAT,
               .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
               .kind = gpu::ImageKind::Array})};
}

void ShadowPass::record(gpu::CommandList& commands, FrameView& frame, DeformedMesh& mesh,
                        ShadowMaps& maps) const {
  commands.beginPass("shadow");
  commands.use(mesh.indices, gpu::Access::Index);
  for (std::uint32_t view = 0; view < frame.shadowViews; ++view) {
    commands.bind(pipeline_, {.frame = frame.data, .positions = mesh.positions}, {},
                  {.view = view});
    const gpu::DepthTarget depth{.image = &maps.depth, .layer = view};
    commands.beginRendering({}, &depth);
    commands.drawIndexed(mesh.indices, mesh.castingIndexCount);
    commands.endRendering();
  }
  commands.endPass();
}

}  // namespace opaline::passes
