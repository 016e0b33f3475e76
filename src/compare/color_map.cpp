#include "compare/color_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "compare/cie_color.h"
#include "opaline/tone.h"

namespace opaline::compare {

namespace {

/// A curve through CIE L*a*b* that stays inside sRGB: lightness and hue rise evenly, chroma is
/// greatest near the middle. Its parameter, in [0,1], is not proportional to its length.
Triple curve(double s) {
  constexpr double darkest = 10;
  constexpr double lightest = 92;
  constexpr double firstHueDegrees = -75;
  constexpr double lastHueDegrees = 95;
  constexpr double mostChroma = 70;
  constexpr double firstPhase = 0.1;
  constexpr double lastPhase = 0.88;
  constexpr double pi = std::numbers::pi;
  const double hue = std::lerp(firstHueDegrees, lastHueDegrees, s) * pi / 180;
  const double chroma = mostChroma * std::sin(pi * std::lerp(firstPhase, lastPhase, s));
  return {std::lerp(darkest, lightest, s), chroma * std::cos(hue), chroma * std::sin(hue)};
}

constexpr std::size_t pieces = 1024;

/// Length of the curve, in CIE 1976 color differences, up to the end of each piece.
using Lengths = std::array<double, pieces + 1>;

Lengths measure() {
  Lengths lengths{};
  Triple last = curve(0);
  for (std::size_t i = 1; i <= pieces; ++i) {
    const Triple next = curve(static_cast<double>(i) / pieces);
    lengths[i] =
        lengths[i - 1] + std::hypot(next[0] - last[0], next[1] - last[1], next[2] - last[2]);
    last = next;
  }
  return lengths;
}

}  // namespace

std::array<double, 3> perceptualLab(double unit) {
  static const Lengths lengths = measure();
  const double length = std::clamp(unit, 0.0, 1.0) * lengths.back();
  const auto after = std::upper_bound(lengths.begin(), lengths.end() - 1, length);
  const auto before = static_cast<std::size_t>(after - lengths.begin()) - 1;
  const double within = (length - lengths[before]) / (lengths[before + 1] - lengths[before]);
  return curve((static_cast<double>(before) + within) / pieces);
}

Rgb8 perceptualColor(double unit) {
  const Triple linear = linearRgbFromLab(perceptualLab(unit));
  Rgb8 color{};
  for (std::size_t c = 0; c < color.size(); ++c) {
    const auto channel = static_cast<float>(std::clamp(linear[c], 0.0, 1.0));
    color[c] = static_cast<std::uint8_t>(std::lround(encodeSrgb(channel) * 255.0F));
  }
  return color;
}

}  // namespace opaline::compare
