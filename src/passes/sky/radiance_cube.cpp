#include "passes/sky/radiance_cube.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gpu/device.h"
#include "gpu/transfer.h"
#include "passes/cube_direction.h"

namespace opaline::passes {

namespace {

using Texel = std::array<float, 4>;

constexpr std::uint32_t faceSize = 32;     // as fine as the parts of the sky
constexpr std::uint32_t samplesAlong = 4;  // along each edge of a texel

Texel meanOf(const std::vector<Texel>& texels) {
  Texel mean{};
  for (const Texel& texel : texels)
    for (std::size_t c = 0; c < 4; ++c) mean[c] += texel[c] / static_cast<float>(texels.size());
  return mean;
}

Texel sampled(const SkyParts& sky, std::uint32_t face, std::uint32_t x, std::uint32_t y,
              std::uint32_t size) {
  constexpr float step = 1.0F / samplesAlong;
  std::vector<Texel> samples;
  for (std::uint32_t i = 0; i < samplesAlong * samplesAlong; ++i) {
    const std::uint32_t row = i / samplesAlong;
    const float across =
        static_cast<float>(x) + (static_cast<float>(i % samplesAlong) + 0.5F) * step;
    const float down = static_cast<float>(y) + (static_cast<float>(row) + 0.5F) * step;
    const Rgb radiance = sky.radianceAt(
        cubeDirection(face, across / static_cast<float>(size), down / static_cast<float>(size)));
    samples.push_back({radiance[0], radiance[1], radiance[2], 1});
  }
  return meanOf(samples);
}

std::vector<Texel> sampledFace(const SkyParts& sky, std::uint32_t face, std::uint32_t size) {
  std::vector<Texel> texels;
  for (std::uint32_t y = 0; y < size; ++y)
    for (std::uint32_t x = 0; x < size; ++x) texels.push_back(sampled(sky, face, x, y, size));
  return texels;
}

std::vector<Texel> halved(const std::vector<Texel>& texels, std::uint32_t size) {
  std::vector<Texel> half;
  for (std::size_t y = 0; y < size; y += 2)
    for (std::size_t x = 0; x < size; x += 2)
      half.push_back(meanOf({texels[y * size + x], texels[y * size + x + 1],
                             texels[(y + 1) * size + x], texels[(y + 1) * size + x + 1]}));
  return half;
}

}  // namespace

gpu::GpuImage makeRadianceCube(gpu::Device& device, const SkyParts& sky) {
  const std::uint32_t size = sky.parts.empty() ? 1 : faceSize;
  const auto levels = static_cast<std::uint32_t>(std::bit_width(size));
  gpu::GpuImage cube(device, {.name = "radiance of the sky",
                              .width = size,
                              .height = size,
                              .layers = 6,
                              .mipLevels = levels,
                              .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                              .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                              .kind = gpu::ImageKind::CubeArray});
  for (std::uint32_t face = 0; face < 6; ++face) {
    std::vector<Texel> texels = sampledFace(sky, face, size);
    for (std::uint32_t level = 0; level < levels; ++level) {
      if (level > 0) texels = halved(texels, size >> (level - 1));
      gpu::uploadImage(device, cube, std::as_bytes(std::span<const Texel>(texels)), face, level);
    }
  }
  return cube;
}

}  // namespace opaline::passes
