#pragma once

#include <fmt/format.h>

#include "opaline/error.h"
#include "opaline/image.h"

namespace opaline::core {

/// Throws UsageError for an image that is not sound.
template <typename AnImage>
void requireSound(const AnImage& image) {
  if (isSound(image)) return;
  throw UsageError(fmt::format("An image of {}x{} pixels has {} values; four a pixel are needed.",
                               image.width, image.height, image.rgba.size()));
}

}  // namespace opaline::core
