#include "compose.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "passes/cube_direction.h"

namespace opaline::figures {

namespace {

void fillWith(Image8& image, const Paper& paper) {
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    std::copy(paper.begin(), paper.end(),
              image.rgba.begin() + static_cast<std::vector<std::uint8_t>::difference_type>(i));
    image.rgba[i + 3] = 255;
  }
}

Image8 blank(int width, int height) {
  return {width, height,
          std::vector<std::uint8_t>(std::size_t{4} * static_cast<std::size_t>(width) *
                                    static_cast<std::size_t>(height))};
}

/// Copies a panel so that its upper left pixel is at (left, top).
void blit(const Image8& panel, Image8& target, int left, int top) {
  using Offset = std::vector<std::uint8_t>::difference_type;
  for (int y = 0; y < panel.height; ++y) {
    const Offset from = Offset{4} * y * panel.width;
    const Offset to = Offset{4} * (Offset{top + y} * target.width + left);
    std::copy_n(panel.rgba.begin() + from, Offset{4} * panel.width, target.rgba.begin() + to);
  }
}

}  // namespace

Image halved(const Image& image) {
  Image half(image.width / 2, image.height / 2);
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      float* mean = half.pixel(x, y);
      for (const int dy : {0, 1}) {
        for (const int dx : {0, 1}) {
          const float* p = image.pixel(2 * x + dx, 2 * y + dy);
          for (int c = 0; c < 3; ++c) mean[c] += p[c] * p[3];
          mean[3] += p[3];
        }
      }
      for (int c = 0; c < 3; ++c) mean[c] = mean[3] > 0 ? mean[c] / mean[3] : 0;
      mean[3] /= 4;
    }
  }
  return half;
}

Image8 plain(const Image& image, const Paper& paper) {
  Image8 picture = blank(image.width, image.height);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const float coverage = std::clamp(image.rgba[i + 3], 0.0F, 1.0F);
    for (std::size_t c = 0; c < 3; ++c) {
      const float above = 255 * std::clamp(image.rgba[i + c], 0.0F, 1.0F);
      const auto under = static_cast<float>(paper[c]);
      picture.rgba[i + c] =
          static_cast<std::uint8_t>(std::lround(under + coverage * (above - under)));
    }
    picture.rgba[i + 3] = 255;
  }
  return picture;
}

Image8 padded(const Image8& picture, int width, const Paper& paper) {
  Image8 wider = blank(width, picture.height);
  fillWith(wider, paper);
  blit(picture, wider, 0, 0);
  return wider;
}

Image8 sheet(const std::vector<Image8>& panels, int columns, int gap, const Paper& paper) {
  if (panels.empty() || columns < 1) throw std::invalid_argument("a sheet without panels");
  const int width = panels.front().width;
  const int height = panels.front().height;
  const int count = static_cast<int>(panels.size());
  const int across = std::min(columns, count);
  const int down = (count + columns - 1) / columns;
  Image8 picture = blank(across * width + (across - 1) * gap, down * height + (down - 1) * gap);
  fillWith(picture, paper);
  int index = 0;
  for (const Image8& panel : panels) {
    if (panel.width != width || panel.height != height) {
      throw std::invalid_argument("panels of different sizes");
    }
    blit(panel, picture, index % columns * (width + gap), index / columns * (height + gap));
    ++index;
  }
  return picture;
}

Image cubeCross(int faceSize, const std::function<Rgb(const Vec3& direction)>& colour) {
  struct Place {
    int column;
    int row;
  };
  constexpr std::array<Place, 6> places{{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}};
  Image cross(4 * faceSize, 3 * faceSize);
  const auto size = static_cast<float>(faceSize);
  for (std::uint32_t face = 0; face < 6; ++face) {
    for (int y = 0; y < faceSize; ++y) {
      for (int x = 0; x < faceSize; ++x) {
        const Rgb seen = colour(passes::cubeDirection(face, (static_cast<float>(x) + 0.5F) / size,
                                                      (static_cast<float>(y) + 0.5F) / size));
        float* pixel =
            cross.pixel(places[face].column * faceSize + x, places[face].row * faceSize + y);
        std::copy(seen.begin(), seen.end(), pixel);
        pixel[3] = 1;
      }
    }
  }
  return cross;
}

}  // namespace opaline::figures
