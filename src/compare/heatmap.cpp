#include "opaline/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "compare/color_map.h"
#include "compare/digits.h"
#include "opaline/error.h"

namespace opaline::compare {

namespace {

constexpr Rgb8 white{255, 255, 255};
constexpr Rgb8 ink{32, 32, 32};

/// Where the scale goes, in pixels; all lengths grow with the picture so that it stays legible.
struct Layout {
  int scale;
  int barLeft;
  int barTop;
  int barWidth;
  int barHeight;
  int width;
  int height;
};

Layout layOut(int mapWidth, int mapHeight) {
  constexpr int pixelsPerScale = 384;
  constexpr int leastHeight = 96;
  constexpr int gap = 8;
  constexpr int bar = 12;
  constexpr int tick = 6;
  constexpr int characters = 7;  // 0.0002%
  Layout layout{};
  layout.scale = std::max(1, mapHeight / pixelsPerScale);
  layout.height = std::max(mapHeight, leastHeight * layout.scale);
  layout.barLeft = mapWidth + gap * layout.scale;
  layout.barTop = gap * layout.scale;
  layout.barWidth = bar * layout.scale;
  layout.barHeight = layout.height - 2 * layout.barTop;
  layout.width = layout.barLeft + (bar + tick + characters * glyphAdvance) * layout.scale;
  return layout;
}

/// How far apart the selected pixels are, if they are those of every N-th column and row: then 1 or
/// more lie N beside others, and N below.
int spacingOf(const Selection& selection, int width) {
  int spacing = 0;
  const auto pixelsAcross = static_cast<std::size_t>(width);
  for (std::size_t i = 0; i < selection.size(); ++i) {
    if (selection[i] == 0) continue;
    spacing = std::gcd(spacing, static_cast<int>(i % pixelsAcross));
    spacing = std::gcd(spacing, static_cast<int>(i / pixelsAcross));
    if (spacing == 1) return 1;
  }
  const auto step = static_cast<std::size_t>(spacing);
  bool beside = false;
  bool below = false;
  for (std::size_t i = 0; i < selection.size(); ++i) {
    if (selection[i] == 0) continue;
    const std::size_t under = i + step * pixelsAcross;
    beside = beside || (i % pixelsAcross + step < pixelsAcross && selection[i + step] != 0);
    below = below || (under < selection.size() && selection[under] != 0);
  }
  return spacing > 1 && beside && below ? spacing : 1;
}

/// Steps of a scale: five, four and five for 1, 2 and 5 times a power of ten.
int stepsTo(double top) {
  const double leading = top / std::pow(10, std::floor(std::log10(top * (1 + 1e-9))));
  return leading > 1.5 && leading < 3 ? 4 : 5;
}

void drawScale(Image8& picture, const Layout& layout, double top) {
  for (int row = 0; row < layout.barHeight; ++row) {
    const double unit = 1 - row / static_cast<double>(layout.barHeight - 1);
    fillRectangle(picture, layout.barLeft, layout.barTop + row, layout.barWidth, 1,
                  perceptualColor(unit));
  }
  const int steps = stepsTo(top);
  for (int i = 0; i <= steps; ++i) {
    const int y = layout.barTop +
                  static_cast<int>(std::lround((layout.barHeight - 1) * (1 - i / double(steps))));
    const int right = layout.barLeft + layout.barWidth;
    fillRectangle(picture, right, y - layout.scale / 2, 3 * layout.scale, layout.scale, ink);
    drawNumber(picture, right + 5 * layout.scale, y - glyphHeight * layout.scale / 2, layout.scale,
               fmt::format("{:.4g}%", 100 * top * i / steps), ink);
  }
}

}  // namespace

double heatmapTop(const Plane& errors, const Selection& selection) {
  constexpr double exceeded = 0.01;
  std::vector<float> selected;
  for (std::size_t i = 0; i < selection.size(); ++i) {
    if (selection[i] != 0) selected.push_back(errors.values[i]);
  }
  double bound = 0;
  if (!selected.empty()) {
    const auto rank = static_cast<std::ptrdiff_t>(
        std::ceil((1 - exceeded) * static_cast<double>(selected.size())) - 1);
    std::nth_element(selected.begin(), selected.begin() + rank, selected.end());
    bound = static_cast<double>(selected[static_cast<std::size_t>(rank)]);
  }
  for (double power = 1e-5; power < 1e30; power *= 10) {
    for (const double leading : {1.0, 2.0, 5.0}) {
      if (bound <= leading * power * (1 + 1e-6)) return leading * power;
    }
  }
  return 1e30;
}

Image8 drawHeatmap(const Plane& errors, const Selection& selection, double top) {
  if (errors.values.size() != selection.size() || !(top > 0))
    throw UsageError("a heat map needs a selection of its size and a top above 0");
  const Layout layout = layOut(errors.width, errors.height);
  Image8 picture{layout.width, layout.height, {}};
  picture.rgba.assign(std::size_t{4} * static_cast<std::size_t>(layout.width) *
                          static_cast<std::size_t>(layout.height),
                      255);
  fillRectangle(picture, 0, 0, layout.width, layout.height, white);
  const int spacing = spacingOf(selection, errors.width);
  for (int y = 0; y < errors.height; ++y) {
    for (int x = 0; x < errors.width; ++x) {
      const std::size_t pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(errors.width) +
          static_cast<std::size_t>(x);
      if (selection[pixel] == 0) continue;
      const Rgb8 color = perceptualColor(static_cast<double>(errors.values[pixel]) / top);
      fillRectangle(picture, x, y, std::min(spacing, errors.width - x),
                    std::min(spacing, errors.height - y), color);
    }
  }
  drawScale(picture, layout, top);
  return picture;
}

}  // namespace opaline::compare
