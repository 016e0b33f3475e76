#include "scene/material.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "bssrdf/paint.h"
#include "opaline/scene.h"
#include "opaline/tone.h"

namespace opaline {

namespace scene {

namespace {

// Some thousand values of one channel, spread evenly over the picture.
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

bool letsLightThrough(const OpaqueMaterial& material) {
  return !material.unlit && material.diffuseTransmission > 0;
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

namespace {

/// The linear colour that in each channel is as bright as all pixels but the brightest twentieth.
/// The medium below a paint gets it, since a paint can only darken.
Rgb brightColor(const TexturePixels& pixels) {
  constexpr std::size_t brightest = 20;  // the brightest one in so many is ignored
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

/// The picture with every shade of a channel, in [0, 1], mapped to another. All shades are linear.
template <typename Seen>
std::shared_ptr<const TexturePixels> recolored(const TexturePixels& pixels, const Seen& seen) {
  constexpr std::size_t shades = 65536;
  std::array<std::vector<int>, 3> known;
  for (std::vector<int>& of : known) of.assign(shades, -1);
  TexturePixels result = pixels;
  for (std::size_t i = 0; i < result.rgba.size(); ++i) {
    const std::size_t c = i % 4;
    if (c == 3) continue;
    const std::uint16_t shade = result.rgba[i];
    int& found = known[c][shade];
    if (found < 0) {
      const double linear = double{decodeSrgb(static_cast<float>(shade) / 65535.0F)};
      found = static_cast<int>(std::lround(65535 * encodeSrgb(seen(linear, c))));
    }
    result.rgba[i] = static_cast<std::uint16_t>(found);
  }
  return std::make_shared<const TexturePixels>(std::move(result));
}

/// The picture with its albedos replaced by the colours in which bodies of these albedos are seen.
std::shared_ptr<const TexturePixels> asSeen(const TexturePixels& pixels,
                                            const Appearance& appearance) {
  return recolored(pixels, [&](double albedo, std::size_t channel) {
    Appearance one = appearance;
    one.color.fill(std::min(albedo * appearance.color[channel], 1.0));
    return colorOf(mediumOf(one))[channel];
  });
}

/// The picture with each colour of a ball replaced by that of an infinitely thick body under the
/// same layers.
std::shared_ptr<const TexturePixels> asOnThick(const TexturePixels& pixels,
                                               const Appearance& appearance, const Medium& medium) {
  const auto colors = bssrdf::layerColors(medium, appearance.ballMm);
  return recolored(pixels, [&](double shade, std::size_t channel) {
    const auto& [thick, ball] = colors[channel];
    const double wanted = shade * appearance.color[channel];
    const auto below = std::lower_bound(ball.begin(), ball.end(), wanted, std::greater<>());
    if (below == ball.begin()) return static_cast<float>(thick.front());
    if (below == ball.end()) return static_cast<float>(thick.back() * wanted / ball.back());
    const auto i = static_cast<std::size_t>(below - ball.begin());
    const double part = (ball[i - 1] - wanted) / (ball[i - 1] - ball[i]);
    return static_cast<float>(std::lerp(thick[i - 1], thick[i], part));
  });
}

}  // namespace

Translucent bodyOf(const Appearance& appearance, std::optional<Texture> colors) {
  if (!colors) return {mediumOf(appearance), std::nullopt};
  if (appearance.colorModel == ColorModel::Khr) {
    colors->pixels = asSeen(*colors->pixels, appearance);
    Appearance seen = appearance;
    seen.colorModel = ColorModel::Observed;
    seen.color = {1, 1, 1};
    return bodyOf(seen, std::move(colors));
  }
  const Rgb bright = brightColor(*colors->pixels);
  Appearance below = appearance;
  Paint paint;
  for (std::size_t c = 0; c < 3; ++c) {
    paint.color[c] = static_cast<float>(appearance.color[c]);
    below.color[c] *= double{bright[c]};
  }
  Medium medium = mediumOf(below);
  if (appearance.ballMm > 0) {
    colors->pixels = asOnThick(*colors->pixels, appearance, medium);
    paint.color = {1, 1, 1};
  }
  paint.colorTexture = std::move(colors);
  return {std::move(medium), std::move(paint)};
}

Paint paintOn(const Medium& medium, Texture colors) {
  const Rgb bare = colorOf(medium);
  const Rgb bright = brightColor(*colors.pixels);
  Paint paint{.name = medium.name, .colorTexture = std::move(colors)};
  for (std::size_t c = 0; c < 3; ++c)
    paint.color[c] = bright[c] > 0 ? std::min(bare[c] / bright[c], Paint::mostColor) : 1.0F;
  return paint;
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
