#pragma once

#include <array>

#include "paper/atlas/chart_mesh.h"

namespace opaline::atlas {

/// First and end of the texels of a row, or of the part of it from `first` to before `end`, whose
/// centres lie in a triangle, all in texels. Rounding may add or lose one at either side.
std::array<int, 2> texelsInRow(const std::array<Point2, 3>& corners, int y, int first, int end);

}  // namespace opaline::atlas
