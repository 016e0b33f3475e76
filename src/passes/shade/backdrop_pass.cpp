#include "passes/shade/backdrop_pass.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "gpu/device.h"
#include "passes/environment_map.h"

namespace opaline::passes {

BackdropPass::BackdropPass(gpu::Device& device)
    : sampler_(device, gpu::Filter::Linear, gpu::Wrap::Repeat, gpu::Wrap::Clamp),
      backdrop_(device, "backdrop") {}

Backdrop BackdropPass::makeBackdrop(gpu::Device& device, const Image* environment) {
  const bool there = environment != nullptr && environment->width > 0;
  return {makeEnvironmentMap(device, there ? *environment : Image(1, 1))};
}

void BackdropPass::record(gpu::CommandList& commands, const Inputs& inputs,
                          const SeenSurfaces& seen, gpu::GpuImage& radiance) const {
  commands.beginPass("backdrop");
  commands.bind(backdrop_,
                {.frame = seen.frame.data,
                 .words = seen.surfaces.words,
                 .environment = {inputs.backdrop.environment, sampler_},
                 .radiance = radiance},
                {.ambient = glm::vec4(glm::make_vec3(inputs.ambient.data()), 0),
                 .samples = inputs.samples,
                 .fills = inputs.fills ? 1.0F : 0.0F});
  commands.dispatchTiles(radiance);
  commands.endPass();
}

}  // namespace opaline::passes
