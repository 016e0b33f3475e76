#pragma once

#include <array>

namespace opaline::compare {

using Triple = std::array<double, 3>;

/// Converts linear sRGB to CIE XYZ relative to the white point, which is (1,1,1).
Triple relativeXyz(const Triple& linearRgb);
Triple linearRgbFromRelativeXyz(const Triple& xyz);

/// CIE 1976 L*a*b*.
Triple lab(const Triple& linearRgb);
/// Components are outside [0,1] if the color is outside sRGB's gamut.
Triple linearRgbFromLab(const Triple& lab);

}  // namespace opaline::compare
