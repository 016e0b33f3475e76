#include "scene/material.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "opaline/scene.h"
#include "opaline/tone.h"

namespace opaline {

namespace scene {

namespace {

// Of one channel, those of some thousand pixels, spread evenly.
std::vector<float> someOf(const TexturePixels& pixels, std::size_t channel) {
  constexpr std::size_t wanted = 4096;
  const std::size_t count = pixels.rgba.size() / 4;
  const std::size_t step = std::max<std::size_t>(count / wanted, 1) | 1U;
  std::vector<float> values;
  for (std::size_t i = 0; i < count; i += step)
    values.push_back(static_cast<float>(pixels.rgba[4 * i + channel]) / 65535.0F);
  return values;
}

double meanOf(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) /
         static_cast<double>(std::max<std::size_t>(values.size(), 1));
}

}  // namespace

bool isMetal(const OpaqueMaterial& material) {
  constexpr std::size_t blue = 2;
  const auto& texture = material.metallicRoughnessTexture;
  const double mean = texture ? meanOf(someOf(*texture->pixels, blue)) : 1;
  return mean * double{material.metallic} > 0.5;
}

std::optional<TranslucentSurface> surfaceFrom(const OpaqueMaterial& material) {
  if (!material.metallicRoughnessTexture && !material.normalTexture) return std::nullopt;
  TranslucentSurface surface;
  if (material.metallicRoughnessTexture) surface.roughness = material.roughness;
  surface.metallicRoughnessTexture = material.metallicRoughnessTexture;
  surface.normalTexture = material.normalTexture;
  surface.normalScale = material.normalScale;
  return surface;
}

Rgb brightColor(const TexturePixels& pixels) {
  constexpr std::size_t brightest = 20;  // one in so many
  Rgb bright{};
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<float> values = someOf(pixels, c);
    if (values.empty()) continue;
    const auto at = values.end() - 1 - static_cast<std::ptrdiff_t>(values.size() / brightest);
    std::nth_element(values.begin(), at, values.end());
    bright[c] = decodeSrgb(*at);
  }
  return bright;
}

}  // namespace scene

Material materialOf(const Object& object) {
  return {object.medium, object.paint, object.surface, object.opaque};
}

void giveMaterial(const Material& material, Object& object) {
  object.medium = material.medium;
  object.paint = material.paint;
  object.surface = material.surface;
  object.opaque = material.opaque;
}

OpaqueMaterial mattMaterial(const Rgb& color) {
  OpaqueMaterial material;
  material.baseColor = color;
  material.specular = 0;
  return material;
}

}  // namespace opaline
