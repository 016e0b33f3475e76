#include "paper/mapped_surface_pass.h"

#include "gpu/device.h"

namespace opaline::paper {

MappedSurfacePass::MappedSurfacePass(gpu::Device& device)
    : pipeline_(device, "surface on the map",
                {.colorFormats = {VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_R16G16B16A16_SFLOAT,
                                  VK_FORMAT_R32G32_SFLOAT, VK_FORMAT_R32G32B32A32_SFLOAT},
                 .depthFormat = VK_FORMAT_D32_SFLOAT,
                 .depth = gpu::DepthMode::Write}) {}

gpu::GpuImage MappedSurfacePass::makePlace(gpu::Device& device, std::uint32_t width,
                                           std::uint32_t height) {
  return {device,
          {.name = "surface place",
           .width = width,
           .height = height,
           .format = VK_FORMAT_R32G32_SFLOAT,
           .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT}};
}

void MappedSurfacePass::record(gpu::CommandList& commands, const Inputs& inputs,
                               passes::VisibleSurface& surface, gpu::GpuImage& place) const {
  commands.beginPass("surface");
  commands.use(inputs.flat.indices, gpu::Access::Index);
  commands.bind(pipeline_,
                {.frame = inputs.frame.data,
                 .positions = inputs.mesh.positions,
                 .normals = inputs.mesh.normals,
                 .corners = inputs.flat.corners,
                 .exitances = inputs.vertexExitance,
                 .charts = inputs.charts},
                {}, {.jitter = inputs.jitter});
  const gpu::DepthTarget depth{.image = &surface.depth};
  commands.beginRendering({{.image = &surface.position},
                           {.image = &surface.normal},
                           {.image = &place},
                           {.image = &surface.exitance}},
                          &depth);
  commands.drawIndexed(inputs.flat.indices, inputs.flat.indexCount);
  commands.endRendering();
  commands.endPass();
}

}  // namespace opaline::paper
