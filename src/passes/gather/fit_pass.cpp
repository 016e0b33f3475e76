#include "passes/gather/fit_pass.h"

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "shaders/shared/frame.h"

namespace opaline::passes {

FitPass::FitPass(gpu::Device& device) : pipeline_(device, "fit") {}

FrameView FitPass::makeView(gpu::Device& device) {
  return {gpu::Buffer(
      device, {.name = "frame view",
               .bytes = sizeof(shared::FrameData),
               .usage = VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT})};
}

void FitPass::record(gpu::CommandList& commands, gpu::Buffer& upload, std::size_t offset,
                     DeformedMesh& mesh, FrameView& frame) const {
  commands.beginPass("fit");
  commands.copyBuffer(upload, frame.data, sizeof(shared::FrameData), offset);
  commands.bind(pipeline_, {.frame = frame.data, .bounds = mesh.bounds});
  commands.dispatch(1);
  commands.endPass();
}

}  // namespace opaline::passes
