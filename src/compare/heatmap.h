#pragma once

#include "compare/figures.h"
#include "compare/plane.h"
#include "core/image_file.h"

namespace opaline::compare {

/// The least of 1, 2 and 5 times a power of ten, from 1e-5 on, that no more than 1 % of the
/// selected errors exceed.
double heatmapTop(const Plane& errors, const Selection& selection);

/// Relative errors in colors of equal steps from 0 to `top`, above 0, with a scale in percent at
/// the right; where nothing is selected the picture is white.
core::Image8 drawHeatmap(const Plane& errors, const Selection& selection, double top);

}  // namespace opaline::compare
