#pragma once

#include <span>

#include "studio.h"

namespace opaline::figures {

/// A picture, its name without .jpg, and how it is made.
struct Figure {
  const char* name;
  void (*make)(Studio& studio, const char* name);
};

/// Figures 2, 7 and 8 of Gong et al. 2008.
std::span<const Figure> stillFigures();

/// Figure 4.
std::span<const Figure> cubeFigures();

/// Soft shadows of lights of several sizes.
std::span<const Figure> lightFigures();

/// The paper's sum next to the one in object space.
std::span<const Figure> sumFigures();

/// Half-spaces and boundary transport next to light traced through the body.
std::span<const Figure> boundaryFigures();

/// The paper's map, exitance, surfels, and pictures next to them.
std::span<const Figure> variableFigures();

/// Figure 9, and motion that the paper does not show.
std::span<const Figure> motionFigures();

}  // namespace opaline::figures
