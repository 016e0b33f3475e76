#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace opaline {

/// Linear float pixels, four channels (R G B A), rows from top to bottom. A is coverage in [0,1];
/// R G B are not premultiplied.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<float> rgba;  ///< 4 · width · height values

  Image() = default;
  Image(int widthPixels, int heightPixels)
      : width(widthPixels),
        height(heightPixels),
        rgba(std::size_t{4} * static_cast<std::size_t>(widthPixels) *
             static_cast<std::size_t>(heightPixels)) {}

  /// The four numbers of a pixel; row 0 is at the top.
  float* pixel(int x, int y) {
    return &rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x))];
  }
  /// The four numbers of a pixel; row 0 is at the top.
  const float* pixel(int x, int y) const {
    return &rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x))];
  }
};

/// Eight-bit sRGB pixels with straight alpha, rows from top to bottom.
struct Image8 {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Pixels as a picture file stores them: R G B A in [0, 65535], rows from top to bottom. A is 65535
/// if the file has no alpha.
struct TexturePixels {
  int width = 0;                    ///< in [1, 16384]
  int height = 0;                   ///< in [1, 16384]
  std::vector<std::uint16_t> rgba;  ///< 4 · width · height values
  std::string name;                 ///< for messages
};

/// Whether an image has pixels, and exactly four values for each.
template <typename AnImage>
bool isSound(const AnImage& image) {
  return image.width > 0 && image.height > 0 &&
         image.rgba.size() == std::size_t{4} * static_cast<std::size_t>(image.width) *
                                  static_cast<std::size_t>(image.height);
}

}  // namespace opaline
