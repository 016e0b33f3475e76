#include "passes/shade/reflected_sky_pass.h"

#include <algorithm>
#include <cmath>

#include "gpu/device.h"
#include "passes/mechanics.h"

namespace opaline::passes {

namespace {

// Of one sample: a mirror needs one, as antialiasing softens its edges; a wide lobe a few.
std::uint32_t raysOfSample(float alpha) {
  constexpr float raysOfAlpha = 16;
  return static_cast<std::uint32_t>(std::clamp(std::round(raysOfAlpha * alpha), 1.0F, 8.0F));
}

}  // namespace

ReflectedSkyPass::ReflectedSkyPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      pipeline_(device, "reflected sky", rayShader<shaders::ShadeReflectedSky>(device)) {}

ReflectedSky ReflectedSkyPass::makeSky(gpu::Device& device, std::uint32_t width,
                                       std::uint32_t height) {
  return {
      gpu::GpuImage(device, {.name = "reflected sky",
                             .width = width,
                             .height = height,
                             .format = VK_FORMAT_R32_SFLOAT,
                             .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT})};
}

void ReflectedSkyPass::record(gpu::CommandList& commands, const Inputs& inputs,
                              ReflectedSky& sky) const {
  const float alpha = inputs.roughness * inputs.roughness;
  const std::uint32_t rays = raysOfSample(alpha);
  commands.beginPass("reflected sky");
  commands.bind(pipeline_,
                {.frame = inputs.frame.data,
                 .surfacePosition = {inputs.surface.position, nearest_},
                 .surfaceNormal = {inputs.surface.normal, nearest_},
                 .surfaceFacet = {inputs.surface.facet, nearest_},
                 .objects = inputs.tables.objects,
                 .pieceCorners = inputs.rays.corners,
                 .rayHierarchy = passes::rays(inputs.rays),
                 .skyShare = sky.share},
                {.nodeCount = inputs.surfels.firstOfHeight.back(),
                 .piecesPerSurfel = inputs.surfels.piecesPerSurfel,
                 .firstRay = rays * inputs.sample,
                 .rays = rays,
                 .raysInAll = rays * inputs.samples,
                 .alpha = alpha});
  commands.dispatchTiles(sky.share, rays * roundsOfWalk);
  commands.endPass();
}

}  // namespace opaline::passes
