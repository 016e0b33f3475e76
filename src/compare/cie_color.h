#pragma once

#include <array>

namespace opaline::compare {

using Triple = std::array<double, 3>;

/// Linear sRGB to CIE XYZ over that of the white point: (1,1,1) is white.
Triple relativeXyz(const Triple& linearRgb);
Triple linearRgbFromRelativeXyz(const Triple& xyz);

/// CIE 1976 L*a*b*.
Triple lab(const Triple& linearRgb);
/// Components lie outside [0,1] where no sRGB color is that color.
Triple linearRgbFromLab(const Triple& lab);

}  // namespace opaline::compare
