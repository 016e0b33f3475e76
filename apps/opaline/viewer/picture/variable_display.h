#pragma once

#include "opaline/image.h"
#include "opaline/renderer.h"

namespace opaline::app::viewer {

/// The channels of Aov::Surfels.
enum class SurfelIndex { Surfel, Cluster, Node };

/// Whether a variable is light, which exposure and tone curve apply to.
bool isLight(Aov aov);

/// A variable that is not light as colours between 0 and 1 that tell it best: places within their
/// box, directions about grey, counts and lengths from their least to their largest, objects and
/// what holds a pixel's surfel by colours that differ.
Image asColors(const Image& values, Aov aov, SurfelIndex surfelIndex);

}  // namespace opaline::app::viewer
