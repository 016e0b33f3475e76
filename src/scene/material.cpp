#include "scene/material.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace opaline {

namespace scene {

namespace {

// Of one channel, in [0, 1]; of some thousand pixels, spread evenly.
double meanOf(const TexturePixels& pixels, std::size_t channel) {
  constexpr std::size_t wanted = 4096;
  const std::size_t count = pixels.rgba.size() / 4;
  const std::size_t step = std::max<std::size_t>(count / wanted, 1) | 1U;
  std::uint64_t sum = 0;
  std::size_t taken = 0;
  for (std::size_t i = 0; i < count; i += step, ++taken) sum += pixels.rgba[4 * i + channel];
  return static_cast<double>(sum) /
         (65535.0 * static_cast<double>(std::max<std::size_t>(taken, 1)));
}

}  // namespace

bool isMetal(const OpaqueMaterial& material) {
  constexpr std::size_t blue = 2;
  const auto& texture = material.metallicRoughnessTexture;
  const double mean = texture ? meanOf(*texture->pixels, blue) : 1;
  return mean * double{material.metallic} > 0.5;
}

}  // namespace scene

OpaqueMaterial mattMaterial(const Rgb& color) {
  OpaqueMaterial material;
  material.baseColor = color;
  material.specular = 0;
  return material;
}

}  // namespace opaline
