#pragma once

#include "opaline/image.h"
#include "paper/atlas/atlas.h"

namespace opaline::atlas {

/// A picture of the charts, each in its own colour on a dark ground, triangles shaded apart,
/// borders outlined. Linear values; v grows downwards; size in [16, 16384] pixels.
Image drawAtlas(const Atlas& atlas, int size);

}  // namespace opaline::atlas
