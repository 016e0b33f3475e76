#include "passes/sky/sky_pass.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>

#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "environment/bright_directions.h"
#include "environment/sky.h"
#include "gpu/command_list.h"
#include "gpu/device.h"
#include "gpu/transfer.h"
#include "passes/environment_map.h"
#include "passes/sky/irradiance_cubes.h"
#include "passes/sky/radiance_cube.h"
#include "shaders/shared/boundary.h"
#include "shaders/shared/opaque.h"

namespace opaline::passes {

namespace {

constexpr std::uint32_t mostFaceSize = 128;
constexpr std::uint32_t mirrorFaceSize = 256;
constexpr std::uint32_t tileSize = 8;
constexpr std::uint32_t samplesOfLobe = 256;
constexpr float leastRoughness = 0.02F;  // smoother surfaces count as mirrors
constexpr VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT;

gpu::GpuImage makeCubeImage(gpu::Device& device, std::uint32_t size, std::uint32_t levels,
                            VkImageUsageFlags usage) {
  return {device,
          {.name = "reflection of the sky",
           .width = size,
           .height = size,
           .layers = 6,
           .mipLevels = levels,
           .format = format,
           .usage = VK_IMAGE_USAGE_SAMPLED_BIT | usage,
           .kind = gpu::ImageKind::CubeArray}};
}

// A cube of one texel per face.
gpu::GpuImage makeUniformCube(gpu::Device& device, const Rgb& radiance) {
  gpu::GpuImage cube = makeCubeImage(device, 1, 1, VK_IMAGE_USAGE_TRANSFER_DST_BIT);
  const std::array<float, 4> texel{radiance[0], radiance[1], radiance[2], 1};
  for (std::uint32_t face = 0; face < 6; ++face)
    gpu::uploadImage(device, cube, std::as_bytes(std::span<const float>(texel)), face);
  return cube;
}

gpu::Buffer makeBright(gpu::Device& device, const SkyParts& parts) {
  static_assert(shared::brightDirections == BrightDirections::count);
  const BrightDirections bright = brightDirectionsOf(parts);
  std::vector<shared::BrightSky> sky(1);
  sky[0].light = {bright.mean, bright.above, 0, 0};
  for (std::size_t i = 0; i < bright.count; ++i)
    sky[0].towards[i] = glm::vec4(glm::make_vec3(bright.towards[i].data()), 0);
  return gpu::makeBuffer(device, "bright parts of the sky", sky,
                         VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
}

float alphaOf(float roughness) {
  const float least = std::max(roughness, leastRoughness);
  return least * least;
}

// Texels no wider than 0.4 alpha: linear filtering takes at most 2 % from the peak of a GGX lobe.
std::uint32_t faceSizeFor(float roughness) {
  constexpr float face = std::numbers::pi_v<float> / 2;
  const float texels = std::min(face / (0.4F * alphaOf(roughness)), float{mostFaceSize});
  return std::bit_ceil(static_cast<std::uint32_t>(std::ceil(texels)));
}

std::vector<float> glossyRoughnesses() {
  std::vector<float> roughnesses;
  for (std::uint32_t level = 0; level < shared::glossySkyLevels; ++level)
    roughnesses.push_back(static_cast<float>(level) / (shared::glossySkyLevels - 1));
  return roughnesses;
}

}  // namespace

SkyPass::SkyPass(gpu::Device& device)
    : sampler_(device, gpu::Filter::Linear, gpu::Wrap::Repeat, gpu::Wrap::Clamp),
      reflected_(device, "reflection of the sky") {}

Sky SkyPass::makeSky(gpu::Device& device, const Lighting& lighting, float roughness,
                     const std::vector<double>& etas, bool glossy) const {
  Sky sky;
  sky.parts = partsOfSky(lighting);
  sky.radiance = makeRadianceCube(device, sky.parts);
  sky.bright = makeBright(device, sky.parts);
  sky.reflected = reflectedOf(device, lighting, {roughness}, faceSizeFor(roughness));
  if (glossy) sky.glossy = reflectedOf(device, lighting, glossyRoughnesses(), mirrorFaceSize);
  takeEtas(device, etas, sky);
  return sky;
}

void SkyPass::takeEtas(gpu::Device& device, const std::vector<double>& etas, Sky& sky) {
  sky.irradiance = makeIrradianceCubes(device, sky.parts, etas);
}

gpu::GpuImage SkyPass::reflectedOf(gpu::Device& device, const Lighting& lighting,
                                   const std::vector<float>& roughnesses,
                                   std::uint32_t edge) const {
  if (!lighting.environment) return makeUniformCube(device, lighting.ambient);
  const glm::vec4 ambient(glm::make_vec3(lighting.ambient.data()), 0);
  gpu::GpuImage map = makeEnvironmentMap(device, *lighting.environment);
  const auto levels = static_cast<std::uint32_t>(roughnesses.size());
  gpu::GpuImage cube = makeCubeImage(device, edge, levels, VK_IMAGE_USAGE_STORAGE_BIT);
  gpu::CommandList commands(device, "reflection of the sky");
  commands.begin();
  for (std::uint32_t level = 0; level < levels; ++level) {
    const std::uint32_t size = edge >> level;
    // A face covers a quarter of the map's width.
    const float texels = static_cast<float>(map.extent().width) / static_cast<float>(4 * size);
    commands.bind(reflected_, {.latLong = {map, sampler_}, .cube = {cube, level}},
                  {.ambient = ambient,
                   .alpha = alphaOf(roughnesses[level]),
                   .sampleCount = roughnesses[level] < leastRoughness ? 1 : samplesOfLobe,
                   .leastLevel = std::max(std::log2(texels), 0.0F)});
    const std::uint32_t tiles = (size + tileSize - 1) / tileSize;
    commands.dispatch(tiles, tiles, 6);
  }
  commands.submit();
  return cube;
}

}  // namespace opaline::passes
