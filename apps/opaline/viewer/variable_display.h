#pragma once

#include "opaline/image.h"
#include "opaline/renderer.h"

namespace opaline::app::viewer {

/// Whether a variable is light, which exposure and tone curve apply to.
bool isLight(Aov aov);

/// A variable that is not light as colours between 0 and 1 that tell it best: places within their
/// box, directions about grey, counts and lengths from their least to their largest, objects by
/// colours that differ.
Image asColors(const Image& values, Aov aov);

}  // namespace opaline::app::viewer
