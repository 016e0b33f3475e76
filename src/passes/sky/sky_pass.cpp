#include "passes/sky/sky_pass.h"

#include <array>
#include <cstdint>
#include <span>

#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "environment/sky.h"
#include "gpu/command_list.h"
#include "gpu/device.h"
#include "gpu/transfer.h"
#include "passes/environment_map.h"
#include "passes/sky/irradiance_cubes.h"
#include "passes/sky/radiance_cube.h"

namespace opaline::passes {

namespace {

constexpr std::uint32_t skyFaceSize = 128;
constexpr int mostColumns = 2048;  // four times what the faces show
constexpr std::uint32_t tileSize = 8;
constexpr VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT;

gpu::GpuImage makeCubeImage(gpu::Device& device, std::uint32_t size, VkImageUsageFlags usage) {
  return {device,
          {.name = "reflection of the sky",
           .width = size,
           .height = size,
           .layers = 6,
           .format = format,
           .usage = VK_IMAGE_USAGE_SAMPLED_BIT | usage,
           .kind = gpu::ImageKind::CubeArray}};
}

// Of one texel a face.
gpu::GpuImage makeUniformCube(gpu::Device& device, const Rgb& radiance) {
  gpu::GpuImage cube = makeCubeImage(device, 1, VK_IMAGE_USAGE_TRANSFER_DST_BIT);
  const std::array<float, 4> texel{radiance[0], radiance[1], radiance[2], 1};
  for (std::uint32_t face = 0; face < 6; ++face)
    gpu::uploadImage(device, cube, std::as_bytes(std::span<const float>(texel)), face);
  return cube;
}

}  // namespace

SkyPass::SkyPass(gpu::Device& device)
    : sampler_(device, gpu::Filter::Linear, gpu::Wrap::Repeat, gpu::Wrap::Clamp),
      reflected_(device, "reflection of the sky") {}

Sky SkyPass::makeSky(gpu::Device& device, const Lighting& lighting, float roughness,
                     const std::vector<double>& etas) const {
  Sky sky;
  sky.parts = partsOfSky(lighting);
  sky.radiance = makeRadianceCube(device, sky.parts);
  sky.reflected = reflectedOf(device, lighting, roughness);
  takeEtas(device, etas, sky);
  return sky;
}

void SkyPass::takeEtas(gpu::Device& device, const std::vector<double>& etas, Sky& sky) {
  sky.irradiance = makeIrradianceCubes(device, sky.parts, etas);
}

gpu::GpuImage SkyPass::reflectedOf(gpu::Device& device, const Lighting& lighting,
                                   float roughness) const {
  if (!lighting.environment) return makeUniformCube(device, lighting.ambient);
  const glm::vec4 ambient(glm::make_vec3(lighting.ambient.data()), 0);
  gpu::GpuImage map = makeEnvironmentMap(device, *lighting.environment, mostColumns);
  gpu::GpuImage cube = makeCubeImage(device, skyFaceSize, VK_IMAGE_USAGE_STORAGE_BIT);
  gpu::CommandList commands(device, "reflection of the sky");
  commands.begin();
  commands.bind(reflected_, {.latLong = {map, sampler_}, .cube = cube},
                {.ambient = ambient, .alpha = roughness * roughness});
  commands.dispatch(skyFaceSize / tileSize, skyFaceSize / tileSize, 6);
  commands.submit();
  return cube;
}

}  // namespace opaline::passes
