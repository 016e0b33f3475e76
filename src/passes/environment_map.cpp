#include "passes/environment_map.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "gpu/device.h"
#include "gpu/transfer.h"

namespace opaline::passes {

namespace {

// Mean of 2×2 pixels; the last row and column of odd images count twice.
Image halved(const Image& image) {
  Image half(std::max(1, image.width / 2), std::max(1, image.height / 2));
  for (int y = 0; y < half.height; ++y) {
    const float* upper = image.pixel(0, std::min(2 * y, image.height - 1));
    const float* lower = image.pixel(0, std::min(2 * y + 1, image.height - 1));
    float* to = half.pixel(0, y);
    for (int x = 0; x < half.width; ++x) {
      const std::ptrdiff_t left = std::ptrdiff_t{4} * std::min(2 * x, image.width - 1);
      const std::ptrdiff_t right = std::ptrdiff_t{4} * std::min(2 * x + 1, image.width - 1);
      for (int c = 0; c < 4; ++c)
        *to++ = 0.25F * (upper[left + c] + upper[right + c] + lower[left + c] + lower[right + c]);
    }
  }
  return half;
}

std::uint32_t levelsOf(const Image& image) {
  std::uint32_t levels = 1;
  for (int size = std::min(image.width, image.height); size > 1; size /= 2) ++levels;
  return levels;
}

}  // namespace

gpu::GpuImage makeEnvironmentMap(gpu::Device& device, const Image& image, int mostColumns) {
  Image smaller;
  const Image* at = &image;
  const auto halve = [&] {
    smaller = halved(*at);
    at = &smaller;
  };
  while (at->width > mostColumns) halve();
  const std::uint32_t levels = levelsOf(*at);
  gpu::GpuImage map(device,
                    {.name = "environment",
                     .width = static_cast<std::uint32_t>(at->width),
                     .height = static_cast<std::uint32_t>(at->height),
                     .mipLevels = levels,
                     .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                     .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
  for (std::uint32_t level = 0; level < levels; ++level) {
    if (level > 0) halve();
    gpu::uploadImage(device, map, std::as_bytes(std::span<const float>(at->rgba)), 0, level);
  }
  return map;
}

}  // namespace opaline::passes
