#include "scene/material.h"

#include <algorithm>
#include <cstddef>

#include "opaline/tone.h"

namespace opaline {

namespace scene {

namespace {

// Of what one channel stands for; of some thousand pixels, spread evenly.
template <typename Meaning>
double meanOf(const TexturePixels& pixels, std::size_t channel, const Meaning& meaning) {
  constexpr std::size_t wanted = 4096;
  const std::size_t count = pixels.rgba.size() / 4;
  const std::size_t step = std::max<std::size_t>(count / wanted, 1) | 1U;
  double sum = 0;
  std::size_t taken = 0;
  for (std::size_t i = 0; i < count; i += step, ++taken)
    sum += double{meaning(static_cast<float>(pixels.rgba[4 * i + channel]) / 65535.0F)};
  return sum / static_cast<double>(std::max<std::size_t>(taken, 1));
}

}  // namespace

bool isMetal(const OpaqueMaterial& material) {
  constexpr std::size_t blue = 2;
  const auto& texture = material.metallicRoughnessTexture;
  const double mean =
      texture ? meanOf(*texture->pixels, blue, [](float value) { return value; }) : 1;
  return mean * double{material.metallic} > 0.5;
}

Rgb meanColor(const TexturePixels& pixels) {
  Rgb mean{};
  for (std::size_t c = 0; c < 3; ++c) mean[c] = static_cast<float>(meanOf(pixels, c, decodeSrgb));
  return mean;
}

}  // namespace scene

OpaqueMaterial mattMaterial(const Rgb& color) {
  OpaqueMaterial material;
  material.baseColor = color;
  material.specular = 0;
  return material;
}

}  // namespace opaline
