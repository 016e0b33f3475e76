#pragma once

#include "opaline/image.h"

namespace opaline {

/// Means of 2×2 pixels; the last row and column of odd images count twice.
Image halved(const Image& image);

}  // namespace opaline
