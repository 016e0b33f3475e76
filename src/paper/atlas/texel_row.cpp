#include "paper/atlas/texel_row.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace opaline::atlas {

std::array<int, 2> texelsInRow(const std::array<Point2, 3>& corners, int y, int first, int end) {
  const double middle = y + .5;
  double from = 1e300;
  double to = -1e300;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2& a = corners[i];
    const Point2& b = corners[(i + 1) % 3];
    if (std::min(a[1], b[1]) > middle || std::max(a[1], b[1]) < middle || a[1] == b[1]) continue;
    const double x = a[0] + (middle - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
    from = std::min(from, x);
    to = std::max(to, x);
  }
  if (from > to) return {first, first};
  const auto within = [&](double x) {
    return static_cast<int>(std::clamp(x, static_cast<double>(first), static_cast<double>(end)));
  };
  return {within(std::ceil(from - .5)), within(std::floor(to - .5) + 1)};
}

}  // namespace opaline::atlas
