#pragma once

#include "compare/plane.h"
#include "core/image_file.h"

namespace opaline::compare {

/// Andersson et al. 2020's usual viewer: 0.7 m from a 0.7 m wide screen of 3840 pixels.
constexpr double usualPixelsPerDegree = 67.020643;

/// The difference that somebody sees who flips between two pictures, in [0,1] for each pixel:
/// Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström and Fairchild 2020, "FLIP: A Difference
/// Evaluator for Alternating Images". Alpha is not looked at. Both pictures have the same size;
/// `pixelsPerDegree` of visual angle lies in [1, 1000].
Plane flipMap(const core::Image8& a, const core::Image8& b,
              double pixelsPerDegree = usualPixelsPerDegree);

}  // namespace opaline::compare
