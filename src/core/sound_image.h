#pragma once

#include <fmt/format.h>

#include <cstddef>

#include "opaline/error.h"

namespace opaline::core {

/// Throws UsageError for an image without pixels, or without exactly four values per pixel.
template <typename AnImage>
void requireSound(const AnImage& image) {
  if (image.width > 0 && image.height > 0 &&
      image.rgba.size() == std::size_t{4} * static_cast<std::size_t>(image.width) *
                               static_cast<std::size_t>(image.height))
    return;
  throw UsageError(fmt::format("An image of {}x{} pixels has {} values; four a pixel are needed.",
                               image.width, image.height, image.rgba.size()));
}

}  // namespace opaline::core
