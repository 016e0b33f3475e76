#include "viewer/picture/variable_display.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace opaline::app::viewer {

namespace {

using Color = std::array<float, 3>;

struct Range {
  Color low{std::numeric_limits<float>::max(), std::numeric_limits<float>::max(),
            std::numeric_limits<float>::max()};
  Color high{std::numeric_limits<float>::lowest(), std::numeric_limits<float>::lowest(),
             std::numeric_limits<float>::lowest()};

  float at(float value, std::size_t c) const {
    return high[c] > low[c] ? (value - low[c]) / (high[c] - low[c]) : 0.5F;
  }
};

Range rangeOf(const Image& values) {
  Range range;
  for (std::size_t i = 0; i < values.rgba.size(); i += 4) {
    if (!(values.rgba[i + 3] > 0)) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const float value = values.rgba[i + c];
      if (!std::isfinite(value)) continue;
      range.low[c] = std::min(range.low[c], value);
      range.high[c] = std::max(range.high[c], value);
    }
  }
  return range;
}

// The colour of a hue, given as a part of a full turn.
Color colorOfHue(float turn) {
  const float hue = 6 * turn;
  Color color{};
  for (std::size_t c = 0; c < 3; ++c) {
    const float along = std::fmod(hue + 4 * static_cast<float>(c) + 1, 6.0F);
    color[c] = 0.15F + 0.7F * std::clamp(std::min(along, 4 - along), 0.0F, 1.0F);
  }
  return color;
}

// Distinct colours for neighbouring indices, by the golden angle.
Color colorOfIndex(float index) {
  return colorOfHue(0.381966F * index - std::floor(0.381966F * index));
}

// Colours for many indices, whose neighbours on the surface may differ by any step: pseudo-random
// ones of varied brightness. Grey stands for no index.
Color colorOfAny(float index) {
  if (index < 0) return {0.5F, 0.5F, 0.5F};
  // The finalizer of MurmurHash3 (Appleby 2011).
  auto bits = static_cast<std::uint32_t>(index) + 1;
  bits = (bits ^ (bits >> 16U)) * 0x85ebca6bU;
  bits = (bits ^ (bits >> 13U)) * 0xc2b2ae35U;
  bits ^= bits >> 16U;
  Color color = colorOfHue(static_cast<float>(bits & 0xffffU) / 65536.0F);
  for (float& value : color) value *= 0.55F + 0.45F * static_cast<float>(bits >> 16U) / 65535.0F;
  return color;
}

}  // namespace

bool isLight(Aov aov) {
  return aov == Aov::Radiance || aov == Aov::Exitance || aov == Aov::Irradiance ||
         aov == Aov::DsmIrradiance;
}

Image asColors(const Image& values, Aov aov, SurfelIndex surfelIndex) {
  Image colors = values;
  const auto index = static_cast<std::size_t>(surfelIndex);
  const Range range = rangeOf(values);
  for (std::size_t i = 0; i < colors.rgba.size(); i += 4) {
    if (!(colors.rgba[i + 3] > 0)) continue;
    const Color indexed =
        aov == Aov::Surfels ? colorOfAny(values.rgba[i + index]) : colorOfIndex(values.rgba[i]);
    for (std::size_t c = 0; c < 3; ++c) {
      float& value = colors.rgba[i + c];
      switch (aov) {
        case Aov::Normal:
        case Aov::DsmNormal:
          value = 0.5F + 0.5F * value;
          break;
        case Aov::Object:
        case Aov::Surfels:
          value = indexed[c];
          break;
        default:
          value = range.at(value, c);
          break;
      }
    }
  }
  return colors;
}

}  // namespace opaline::app::viewer
