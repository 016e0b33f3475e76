#include "passes/shade/reflected_sky_pass.h"

#include <algorithm>
#include <cmath>

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "shaders/shaders.h"

namespace opaline::passes {

namespace {

using gpu::Binding;
using gpu::BindingType;

struct SkyConstants {
  std::uint32_t nodeCount;
  std::uint32_t piecesPerSurfel;
  std::uint32_t firstRay;
  std::uint32_t rays;
  std::uint32_t raysInAll;
  float alpha;
};

// Of one sample: a mirror needs one, as antialiasing softens its edges; a wide lobe a few.
std::uint32_t raysOfSample(float alpha) {
  constexpr float raysOfAlpha = 16;
  return static_cast<std::uint32_t>(std::clamp(std::round(raysOfAlpha * alpha), 1.0F, 8.0F));
}

}  // namespace

ReflectedSkyPass::ReflectedSkyPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      pipeline_(device,
                gpu::ComputePipelineOptions{
                    .name = "reflected sky",
                    .shader = device.hasRayQueries() ? shaders::shade_reflected_sky_ray_queries_comp
                                                     : shaders::shade_reflected_sky_comp,
                    .bindings = {{0, BindingType::UniformBuffer},
                                 {1, BindingType::SampledImage},
                                 {2, BindingType::SampledImage},
                                 {3, BindingType::SampledImage},
                                 {4, BindingType::StorageBuffer},
                                 {5, BindingType::TexelBuffer},
                                 raysSlot(device, 6),
                                 {7, BindingType::StorageImage}},
                    .pushConstantBytes = sizeof(SkyConstants),
                }) {}

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
  commands.bind(pipeline_);
  commands.bindResources({Binding::uniform(0, inputs.frame.data),
                          Binding::sampled(1, inputs.surface.position, nearest_),
                          Binding::sampled(2, inputs.surface.normal, nearest_),
                          Binding::sampled(3, inputs.surface.facet, nearest_),
                          Binding::read(4, inputs.tables.objects),
                          Binding::texels(5, inputs.rays.corners), passes::rays(6, inputs.rays),
                          Binding::writeImage(7, sky.share)});
  commands.pushConstants(SkyConstants{.nodeCount = inputs.surfels.firstOfHeight.back(),
                                      .piecesPerSurfel = inputs.surfels.piecesPerSurfel,
                                      .firstRay = rays * inputs.sample,
                                      .rays = rays,
                                      .raysInAll = rays * inputs.samples,
                                      .alpha = alpha});
  commands.dispatchTiles(sky.share);
  commands.endPass();
}

}  // namespace opaline::passes
