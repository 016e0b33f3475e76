#include "compare/plane.h"

#include <algorithm>
#include <cassert>

namespace opaline::compare {

namespace {

/// sums += weight · values, in a loop that the compiler turns into vector instructions.
void accumulate(std::span<double> sums, const float* values, double weight) {
  for (std::size_t x = 0; x < sums.size(); ++x) sums[x] += weight * static_cast<double>(values[x]);
}

void store(std::span<const double> sums, float* values) {
  std::transform(sums.begin(), sums.end(), values,
                 [](double sum) { return static_cast<float>(sum); });
}

}  // namespace

Plane filtered(const Plane& plane, std::span<const double> across, std::span<const double> down) {
  assert(across.size() % 2 == 1 && down.size() % 2 == 1);
  const auto width = static_cast<std::size_t>(plane.width);
  const std::size_t radius = across.size() / 2;
  std::vector<double> sums(width);

  Plane rows(plane.width, plane.height);
  std::vector<float> extended(width + 2 * radius);
  for (std::size_t y = 0; y < static_cast<std::size_t>(plane.height); ++y) {
    const float* const row = &plane.values[y * width];
    std::fill_n(extended.begin(), radius, row[0]);
    std::copy_n(row, width, extended.begin() + static_cast<std::ptrdiff_t>(radius));
    std::fill_n(extended.end() - static_cast<std::ptrdiff_t>(radius), radius, row[width - 1]);
    std::fill(sums.begin(), sums.end(), 0.0);
    for (std::size_t i = 0; i < across.size(); ++i) accumulate(sums, &extended[i], across[i]);
    store(sums, &rows.values[y * width]);
  }

  Plane result(plane.width, plane.height);
  const int reach = static_cast<int>(down.size() / 2);
  for (int y = 0; y < plane.height; ++y) {
    std::fill(sums.begin(), sums.end(), 0.0);
    for (int i = -reach; i <= reach; ++i) {
      const auto from = static_cast<std::size_t>(std::clamp(y + i, 0, plane.height - 1));
      accumulate(sums, &rows.values[from * width], down[static_cast<std::size_t>(i + reach)]);
    }
    store(sums, &result.values[static_cast<std::size_t>(y) * width]);
  }
  return result;
}

}  // namespace opaline::compare
