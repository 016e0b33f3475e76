#pragma once

#include <fmt/format.h>

#include <cstddef>

#include "opaline/error.h"

namespace opaline::core {

/// Whether an image has pixels, and exactly four values for each.
template <typename AnImage>
bool isSound(const AnImage& image) {
  return image.width > 0 && image.height > 0 &&
         image.rgba.size() == std::size_t{4} * static_cast<std::size_t>(image.width) *
                                  static_cast<std::size_t>(image.height);
}

/// Throws UsageError for an image that is not sound.
template <typename AnImage>
void requireSound(const AnImage& image) {
  if (isSound(image)) return;
  throw UsageError(fmt::format("An image of {}x{} pixels has {} values; four a pixel are needed.",
                               image.width, image.height, image.rgba.size()));
}

}  // namespace opaline::core
