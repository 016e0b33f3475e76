#include "environment/halved.h"

#include <algorithm>
#include <cstddef>

namespace opaline {

Image halved(const Image& image) {
  Image half(std::max(1, image.width / 2), std::max(1, image.height / 2));
  for (int y = 0; y < half.height; ++y) {
    const float* upper = image.pixel(0, std::min(2 * y, image.height - 1));
    const float* lower = image.pixel(0, std::min(2 * y + 1, image.height - 1));
    float* to = half.pixel(0, y);
    for (int x = 0; x < half.width; ++x) {
      const std::ptrdiff_t left = std::ptrdiff_t{4} * std::min(2 * x, image.width - 1);
      const std::ptrdiff_t right = std::ptrdiff_t{4} * std::min(2 * x + 1, image.width - 1);
      for (int c = 0; c < 4; ++c)
        *to++ = 0.25F * (upper[left + c] + upper[right + c] + lower[left + c] + lower[right + c]);
    }
  }
  return half;
}

}  // namespace opaline
