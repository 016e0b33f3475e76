#include "passes/gather/shadow_pass.h"

#include <algorithm>

#include "gpu/device.h"

namespace opaline::passes {

namespace {

gpu::GraphicsOptions ofDepth() {
  return {.depthFormat = VK_FORMAT_D32_SFLOAT, .depth = gpu::DepthMode::Write};
}

}  // namespace

ShadowPass::ShadowPass(gpu::Device& device)
    : pipeline_(device, "shadow", ofDepth()), cutOut_(device, "shadow with holes", ofDepth()) {}

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

void ShadowPass::bindCutOut(gpu::CommandList& commands, FrameView& frame, DeformedMesh& mesh,
                            const CutOuts& cutOuts, std::uint32_t view) const {
  commands.bind(cutOut_,
                {.frame = frame.data,
                 .positions = mesh.positions,
                 .vertexAttributes = cutOuts.opaque.attributes,
                 .objectOf = mesh.objectOf},
                {.surfaceMaterials = surfaceMaterials(cutOuts.opaque),
                 .objects = cutOuts.tables.objects,
                 .media = cutOuts.tables.media},
                {.view = view});
}

void ShadowPass::record(gpu::CommandList& commands, FrameView& frame, DeformedMesh& mesh,
                        const CutOuts& cutOuts, ShadowMaps& maps) const {
  commands.beginPass("shadow");
  commands.use(mesh.indices, gpu::Access::Index);
  for (std::uint32_t view = 0; view < frame.shadowViews; ++view) {
    // What it reads is ordered before the drawing begins.
    if (!mesh.cutOut.empty()) bindCutOut(commands, frame, mesh, cutOuts, view);
    commands.bind(pipeline_, {.frame = frame.data, .positions = mesh.positions}, {},
                  {.view = view});
    const gpu::DepthTarget depth{.image = &maps.depth, .layer = view};
    commands.beginRendering({}, &depth);
    for (const IndexRange& range : mesh.whole) {
      if (range.first >= mesh.castingIndexCount) continue;
      commands.drawIndexed(
          mesh.indices, std::min(range.count, mesh.castingIndexCount - range.first), range.first);
    }
    if (!mesh.cutOut.empty()) bindCutOut(commands, frame, mesh, cutOuts, view);
    for (const IndexRange& range : mesh.cutOut)
      commands.drawIndexed(mesh.indices, range.count, range.first);
    commands.endRendering();
  }
  commands.endPass();
}

}  // namespace opaline::passes
