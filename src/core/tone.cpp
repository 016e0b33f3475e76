#include "opaline/tone.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/sound_image.h"
#include "opaline/error.h"

namespace opaline {

namespace {

// Khronos Group 2024, "Khronos PBR Neutral Tone Mapper", the published GLSL function.
Rgb neutral(Rgb color) {
  constexpr float startCompression = 0.8F - 0.04F;
  constexpr float desaturation = 0.15F;

  const float x = std::min({color[0], color[1], color[2]});
  const float offset = x < 0.08F ? x - 6.25F * x * x : 0.04F;
  for (float& channel : color) channel -= offset;

  const float peak = std::max({color[0], color[1], color[2]});
  if (peak < startCompression) return color;

  constexpr float d = 1.0F - startCompression;
  const float newPeak = 1.0F - d * d / (peak + d - startCompression);
  const float g = 1.0F - 1.0F / (desaturation * (peak - newPeak) + 1.0F);
  for (float& channel : color) channel = std::lerp(channel * (newPeak / peak), newPeak, g);
  return color;
}

/// Exposed radiance that the curves can take: neither NaN nor negative nor infinite.
float exposed(float radiance, float factor) {
  constexpr float largest = 1e18F;
  const float value = radiance * factor;
  return value > 0 ? std::min(value, largest) : 0.0F;
}

std::uint8_t quantized(float unit) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(unit, 0.0F, 1.0F) * 255.0F));
}

void requireValid(const ToneOptions& options) {
  if (!(std::abs(options.exposureStops) <= 32.0F)) {
    throw UsageError(fmt::format("The exposure must lie between -32 and 32 stops, not at {}.",
                                 options.exposureStops));
  }
  if (!isUpTo(ToneCurve::Neutral, options.curve))
    throw UsageError(fmt::format("There is no tone curve {}.", static_cast<int>(options.curve)));
  if (!options.background) return;
  for (const float channel : *options.background) {
    if (!std::isfinite(channel)) throw UsageError("The background must be finite.");
  }
}

}  // namespace

float encodeSrgb(float linear) {
  if (linear <= 0.0031308F) return 12.92F * linear;
  return 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

float decodeSrgb(float encoded) {
  if (encoded <= 0.04045F) return encoded / 12.92F;
  return std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

Image8 toneMap(const Image& radiance, const ToneOptions& options) {
  requireValid(options);
  const std::size_t values = radiance.rgba.size();
  if (values > 0) core::requireSound(radiance);
  const float factor = std::exp2(options.exposureStops);
  Image8 result{radiance.width, radiance.height, std::vector<std::uint8_t>(values)};
  for (std::size_t i = 0; i < values; i += 4) {
    Rgb color{};
    for (std::size_t c = 0; c < 3; ++c) color[c] = exposed(radiance.rgba[i + c], factor);
    if (options.curve == ToneCurve::Neutral) color = neutral(color);
    const float alpha = radiance.rgba[i + 3] > 0 ? std::min(radiance.rgba[i + 3], 1.0F) : 0.0F;
    for (std::size_t c = 0; c < 3; ++c) {
      float linear = std::clamp(color[c], 0.0F, 1.0F);
      if (options.background) {
        linear = std::lerp(std::clamp((*options.background)[c], 0.0F, 1.0F), linear, alpha);
      }
      result.rgba[i + c] = quantized(encodeSrgb(linear));
    }
    result.rgba[i + 3] = options.background ? std::uint8_t{255} : quantized(alpha);
  }
  return result;
}

}  // namespace opaline
