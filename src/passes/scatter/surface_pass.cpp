#include "passes/scatter/surface_pass.h"

#include <algorithm>

#include "gpu/device.h"

namespace opaline::passes {

namespace {

gpu::GpuImage makeTarget(gpu::Device& device, const char* name, std::uint32_t width,
                         std::uint32_t height, VkFormat format, VkImageUsageFlags usage) {
  return {device,
          {.name = name,
           .width = width,
           .height = height,
           .format = format,
           .usage = usage | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}};
}

}  // namespace

SurfacePass::SurfacePass(gpu::Device& device)
    : pipeline_(device, "surface",
                {.colorFormats = {VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_R16G16B16A16_SFLOAT,
                                  VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_R16G16_SFLOAT},
                 .depthFormat = VK_FORMAT_D32_SFLOAT,
                 .depth = gpu::DepthMode::Write}) {}

VisibleSurface SurfacePass::makeSurface(gpu::Device& device, std::uint32_t width,
                                        std::uint32_t height) {
  constexpr VkImageUsageFlags color = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
  VisibleSurface surface;
  surface.position =
      makeTarget(device, "surface position", width, height, VK_FORMAT_R32G32B32A32_SFLOAT, color);
  surface.normal =
      makeTarget(device, "surface normal", width, height, VK_FORMAT_R16G16B16A16_SFLOAT, color);
  surface.exitance =
      makeTarget(device, "surface exitance", width, height, VK_FORMAT_R32G32B32A32_SFLOAT, color);
  surface.facet =
      makeTarget(device, "surface facet", width, height, VK_FORMAT_R16G16_SFLOAT, color);
  surface.depth = makeTarget(device, "surface depth", width, height, VK_FORMAT_D32_SFLOAT,
                             VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
  return surface;
}

Exitance SurfacePass::makeExitance(gpu::Device& device, std::uint32_t width, std::uint32_t height,
                                   std::uint32_t vertices) {
  Exitance exitance;
  exitance.image = makeTarget(device, "exitance", width, height, VK_FORMAT_R32G32B32A32_SFLOAT,
                              VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_STORAGE_BIT);
  exitance.vertices = gpu::Buffer(
      device, {.name = "exitance of vertices",
               .bytes = std::max<std::size_t>(vertices, 1) * sizeof(shared::vec4),
               .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT});
  return exitance;
}

void SurfacePass::record(gpu::CommandList& commands, const Inputs& inputs,
                         VisibleSurface& surface) const {
  DeformedMesh& mesh = inputs.mesh;
  commands.beginPass("surface");
  commands.use(mesh.indices, gpu::Access::Index);
  commands.bind(pipeline_,
                {.frame = inputs.frame.data,
                 .positions = mesh.positions,
                 .normals = mesh.normals,
                 .objectOf = mesh.objectOf,
                 .exitances = inputs.vertexExitance},
                {}, {.jitter = inputs.jitter});
  const gpu::DepthTarget depth{.image = &surface.depth};
  commands.beginRendering({{.image = &surface.position},
                           {.image = &surface.normal},
                           {.image = &surface.exitance},
                           {.image = &surface.facet}},
                          &depth);
  commands.drawIndexed(mesh.indices, mesh.indexCount);
  commands.endRendering();
  commands.endPass();
}

}  // namespace opaline::passes
