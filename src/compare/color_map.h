#pragma once

#include <array>
#include <cstdint>

namespace opaline::compare {

using Rgb8 = std::array<std::uint8_t, 3>;

/// sRGB-encoded colors of equal steps to the eye, from a dark blue over red and orange to a light
/// yellow; `unit` is clamped to [0,1]. Also legible in grey and to the color-blind: lightness only
/// rises.
Rgb8 perceptualColor(double unit);

/// The same before it is rounded: L*a*b*.
std::array<double, 3> perceptualLab(double unit);

}  // namespace opaline::compare
