#pragma once

#include <array>
#include <cstdint>

namespace opaline::compare {

using Rgb8 = std::array<std::uint8_t, 3>;

/// sRGB-encoded colors in perceptually equal steps, from dark blue through red and orange to light
/// yellow; `unit` is clamped to [0,1]. Lightness only rises, so they are also legible in grey and
/// to the color-blind.
Rgb8 perceptualColor(double unit);

/// The same color in L*a*b*, before rounding.
std::array<double, 3> perceptualLab(double unit);

}  // namespace opaline::compare
