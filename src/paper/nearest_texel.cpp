#include "paper/nearest_texel.h"

#include <cassert>
#include <cstddef>
#include <limits>

namespace opaline::paper {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

// Column of the nearest covered texel in the same row, for every texel of the row.
void nearestInRow(std::span<const std::uint32_t> row, std::span<std::uint32_t> nearest) {
  std::uint32_t last = none;
  const auto size = static_cast<std::uint32_t>(row.size());
  for (std::uint32_t x = 0; x < size; ++x) {
    if (row[x] != 0) last = x;
    nearest[x] = last;
  }
  last = none;
  for (std::uint32_t x = size; x-- > 0;) {
    if (row[x] != 0) last = x;
    if (last != none && (nearest[x] == none || last - x < x - nearest[x])) nearest[x] = last;
  }
}

// Lower envelope of the parabolas (y - q)² + height(q) of one column.
class Envelope {
 public:
  explicit Envelope(std::size_t size) : rows_(size), starts_(size + 1) {}

  template <typename Height>
  void build(std::uint32_t size, const Height& height) {
    count_ = 0;
    for (std::uint32_t q = 0; q < size; ++q) {
      if (height(q) < 0) continue;
      double start = -std::numeric_limits<double>::infinity();
      while (count_ > 0) {
        const std::uint32_t p = rows_[count_ - 1];
        const double dp = p;
        const double dq = q;
        start = (height(q) + dq * dq - height(p) - dp * dp) / (2 * (dq - dp));
        if (start > starts_[count_ - 1]) break;
        --count_;
        start = -std::numeric_limits<double>::infinity();
      }
      rows_[count_] = q;
      starts_[count_] = start;
      ++count_;
    }
  }

  // Rows of the nearest parabola for y = 0, 1, 2, …, in order of calls.
  bool empty() const { return count_ == 0; }
  std::uint32_t rowAt(std::uint32_t y, std::size_t& cursor) const {
    while (cursor + 1 < count_ && starts_[cursor + 1] < y) ++cursor;
    return rows_[cursor];
  }

 private:
  std::vector<std::uint32_t> rows_;
  std::vector<double> starts_;
  std::size_t count_ = 0;
};

}  // namespace

std::vector<std::uint32_t> nearestCoveredTexel(std::span<const std::uint32_t> coverage,
                                               std::uint32_t size) {
  assert(coverage.size() == std::size_t{size} * size);
  std::vector<std::uint32_t> column(coverage.size());
  for (std::size_t y = 0; y < size; ++y)
    nearestInRow(coverage.subspan(y * size, size),
                 std::span<std::uint32_t>(column).subspan(y * size, size));

  std::vector<std::uint32_t> nearest(coverage.size(), 0);
  Envelope envelope(size);
  for (std::uint32_t x = 0; x < size; ++x) {
    envelope.build(size, [&](std::uint32_t y) {
      const std::uint32_t found = column[std::size_t{y} * size + x];
      if (found == none) return -1.0;
      const double dx = static_cast<double>(found) - static_cast<double>(x);
      return dx * dx;
    });
    if (envelope.empty()) continue;
    std::size_t cursor = 0;
    for (std::uint32_t y = 0; y < size; ++y) {
      const std::uint32_t row = envelope.rowAt(y, cursor);
      nearest[std::size_t{y} * size + x] = row * size + column[std::size_t{row} * size + x];
    }
  }
  return nearest;
}

}  // namespace opaline::paper
