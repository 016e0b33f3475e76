#include "passes/sky/irradiance_cubes.h"

#include <cstddef>
#include <cstdint>
#include <span>

#include "environment/sky_irradiance.h"
#include "gpu/device.h"
#include "gpu/transfer.h"
#include "passes/cube_direction.h"

namespace opaline::passes {

namespace {

// Irradiance is so smooth that linear filtering of 32² texels per face is exact to 0.1 %.
constexpr std::uint32_t ambientFaceSize = 32;

std::vector<float> makeFace(const SkyIrradiance& irradiance, std::uint32_t face) {
  std::vector<float> texels;
  texels.reserve(std::size_t{4} * ambientFaceSize * ambientFaceSize);
  for (std::uint32_t y = 0; y < ambientFaceSize; ++y)
    for (std::uint32_t x = 0; x < ambientFaceSize; ++x) {
      const Vec3 normal = cubeDirection(face, (static_cast<float>(x) + 0.5F) / ambientFaceSize,
                                        (static_cast<float>(y) + 0.5F) / ambientFaceSize);
      for (const double value : irradiance.at(normal)) texels.push_back(static_cast<float>(value));
      texels.push_back(1);
    }
  return texels;
}

}  // namespace

gpu::GpuImage makeIrradianceCubes(gpu::Device& device, const SkyParts& sky,
                                  const std::vector<double>& etas) {
  gpu::GpuImage cubes(device,
                      {.name = "irradiance of the sky",
                       .width = ambientFaceSize,
                       .height = ambientFaceSize,
                       .layers = static_cast<std::uint32_t>(6 * etas.size()),
                       .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                       .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                       .kind = gpu::ImageKind::CubeArray});
  for (std::uint32_t i = 0; i < etas.size(); ++i) {
    const SkyIrradiance irradiance = SkyIrradiance::entering(sky, etas[i]);
    for (std::uint32_t face = 0; face < 6; ++face)
      gpu::uploadImage(device, cubes,
                       std::as_bytes(std::span<const float>(makeFace(irradiance, face))),
                       6 * i + face);
  }
  return cubes;
}

}  // namespace opaline::passes
