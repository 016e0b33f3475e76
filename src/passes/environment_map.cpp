#include "passes/environment_map.h"

#include <algorithm>
#include <cstdint>
#include <span>

#include "environment/halved.h"
#include "gpu/device.h"
#include "gpu/transfer.h"

namespace opaline::passes {

namespace {

std::uint32_t levelsOf(const Image& image) {
  std::uint32_t levels = 1;
  for (int size = std::min(image.width, image.height); size > 1; size /= 2) ++levels;
  return levels;
}

}  // namespace

gpu::GpuImage makeEnvironmentMap(gpu::Device& device, const Image& image) {
  const auto mostColumns = static_cast<int>(device.limits().maxImageDimension2D);
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
