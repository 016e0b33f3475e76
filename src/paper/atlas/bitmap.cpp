#include "paper/atlas/bitmap.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace opaline::atlas {
namespace {

/// Extent along x of the part of an edge within a row of cells.
std::array<double, 2> extentInRow(const Point2& a, const Point2& b, double row) {
  const double dy = b[1] - a[1];
  if (dy == 0) return {std::min(a[0], b[0]), std::max(a[0], b[0])};
  const double t0 = std::clamp((row - a[1]) / dy, 0.0, 1.0);
  const double t1 = std::clamp((row + 1 - a[1]) / dy, 0.0, 1.0);
  const double x0 = a[0] + t0 * (b[0] - a[0]);
  const double x1 = a[0] + t1 * (b[0] - a[0]);
  return {std::min(x0, x1), std::max(x0, x1)};
}

using Runs = std::vector<Silhouette::Run>;

void sortAndJoin(Runs& runs) {
  std::sort(runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.from < b.from; });
  Runs joined;
  for (const auto& run : runs) {
    if (!joined.empty() && run.from <= joined.back().to) {
      joined.back().to = std::max(joined.back().to, run.to);
    } else {
      joined.push_back(run);
    }
  }
  runs = std::move(joined);
}

/// Cells that a border touches, and cells whose centre lies between crossings of the borders.
void addEdge(const Point2& a, const Point2& b, Silhouette& silhouette,
             std::vector<std::vector<double>>& crossings) {
  const auto clampRow = [&](double y) {
    return std::clamp(static_cast<int>(std::floor(y)), 0, silhouette.height - 1);
  };
  const auto clampColumn = [&](double x) {
    return std::clamp(static_cast<int>(std::floor(x)), 0, silhouette.width - 1);
  };
  const double low = std::min(a[1], b[1]);
  const double high = std::max(a[1], b[1]);
  for (int y = clampRow(low); y <= clampRow(high); ++y) {
    const auto index = static_cast<std::size_t>(y);
    const auto [from, to] = extentInRow(a, b, y);
    silhouette.rows[index].push_back({clampColumn(from), clampColumn(to) + 1});
    const double middle = y + .5;
    if (low <= middle && middle < high) {
      crossings[index].push_back(a[0] + (middle - a[1]) / (b[1] - a[1]) * (b[0] - a[0]));
    }
  }
}

}  // namespace

std::optional<Silhouette> silhouetteOf(const Outline& outline, double cosine, double sine,
                                       double cellsPerMm, int size, Point2& corner) {
  std::vector<Point2> turned(outline.places.size());
  corner = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point2 far = {-corner[0], -corner[1]};
  for (const auto& border : outline.borders) {
    const Point2& p = outline.places[border[0]];
    Point2& q = turned[border[0]];
    q = {cellsPerMm * (cosine * p[0] - sine * p[1]), cellsPerMm * (sine * p[0] + cosine * p[1])};
    for (std::size_t i = 0; i < 2; ++i) {
      corner[i] = std::min(corner[i], q[i]);
      far[i] = std::max(far[i], q[i]);
    }
  }
  // A needle may be as long as millions of cells.
  if (!(far[0] - corner[0] < size && far[1] - corner[1] < size)) return std::nullopt;
  Silhouette silhouette;
  silhouette.width = 1 + static_cast<int>(far[0] - corner[0]);
  silhouette.height = 1 + static_cast<int>(far[1] - corner[1]);
  silhouette.rows.resize(static_cast<std::size_t>(silhouette.height));
  std::vector<std::vector<double>> crossings(silhouette.rows.size());
  for (const auto& [i, j] : outline.borders) {
    const Point2 a = {turned[i][0] - corner[0], turned[i][1] - corner[1]};
    const Point2 b = {turned[j][0] - corner[0], turned[j][1] - corner[1]};
    addEdge(a, b, silhouette, crossings);
  }
  for (const auto& row : silhouette.rows) silhouette.pieces += row.size();
  for (std::size_t y = 0; y < silhouette.rows.size(); ++y) {
    auto& xs = crossings[y];
    std::sort(xs.begin(), xs.end());
    for (std::size_t i = 0; i + 1 < xs.size(); i += 2) {
      const int from = std::max(0, static_cast<int>(std::ceil(xs[i] - .5)));
      const int to = std::min(silhouette.width, static_cast<int>(std::ceil(xs[i + 1] - .5)));
      if (from < to) silhouette.rows[y].push_back({from, to});
    }
    sortAndJoin(silhouette.rows[y]);
  }
  return silhouette;
}

Bitmap::Bitmap(int size)
    : size_(size),
      words_((static_cast<std::size_t>(size) + 63) / 64),
      levels_(static_cast<std::size_t>(std::bit_width(static_cast<unsigned>(size)))),
      bits_(levels_ * static_cast<std::size_t>(size) * words_, 0) {}

Bitmap::Word* Bitmap::row(std::size_t level, int y) {
  return &bits_[(level * static_cast<std::size_t>(size_) + static_cast<std::size_t>(y)) * words_];
}

const Bitmap::Word* Bitmap::row(std::size_t level, int y) const {
  return &bits_[(level * static_cast<std::size_t>(size_) + static_cast<std::size_t>(y)) * words_];
}

void Bitmap::orShifted(std::vector<Word>& blocked, const Word* source, int shift) const {
  const auto whole = static_cast<std::size_t>(shift) / 64;
  const auto part = static_cast<unsigned>(shift) % 64;
  const std::size_t last = words_ - whole;
  if (part == 0) {
    for (std::size_t i = 0; i < last; ++i) blocked[i] |= source[i + whole];
    return;
  }
  for (std::size_t i = 0; i + 1 < last; ++i) {
    blocked[i] |= (source[i + whole] >> part) | (source[i + whole + 1] << (64 - part));
  }
  blocked[last - 1] |= source[words_ - 1] >> part;
}

std::optional<Bitmap::Cell> Bitmap::findRoom(const Silhouette& silhouette, int lowestRow,
                                             int highestTop, std::size_t& wordsRead) const {
  const int lastX = size_ - silhouette.width;
  const int lastY = std::min(size_, highestTop) - silhouette.height;
  if (lastX < 0) return std::nullopt;
  std::vector<Word> outside(words_, 0);
  for (int x = lastX + 1; x < static_cast<int>(64 * words_); ++x) {
    outside[static_cast<std::size_t>(x) / 64] |= Word{1} << (static_cast<unsigned>(x) % 64);
  }
  std::vector<Word> blocked(words_);
  for (int y = lowestRow; y <= lastY; ++y) {
    blocked = outside;
    const auto isFull = [&] {
      return std::all_of(blocked.begin(), blocked.end(), [](Word w) { return w == ~Word{0}; });
    };
    for (int r = 0; r < silhouette.height; ++r) {
      for (const auto& run : silhouette.rows[static_cast<std::size_t>(r)]) {
        const int count = run.to - run.from;
        const auto level =
            static_cast<std::size_t>(std::bit_width(static_cast<unsigned>(count)) - 1);
        const Word* source = row(level, y + r);
        wordsRead += 2 * words_;
        orShifted(blocked, source, run.from);
        orShifted(blocked, source, run.to - (1 << level));
      }
      if (r % 4 == 0 && isFull()) break;
    }
    for (std::size_t i = 0; i < words_; ++i) {
      if (blocked[i] == ~Word{0}) continue;
      return Cell{static_cast<int>(64 * i) + std::countr_one(blocked[i]), y};
    }
  }
  return std::nullopt;
}

void Bitmap::occupy(const Silhouette& silhouette, Cell cell, int gutter) {
  for (int r = 0; r < silhouette.height; ++r) {
    const int low = std::max(0, cell.y + r - gutter);
    const int high = std::min(size_ - 1, cell.y + r + gutter);
    for (const auto& run : silhouette.rows[static_cast<std::size_t>(r)]) {
      const int from = std::max(0, cell.x + run.from - gutter);
      const int to = std::min(size_, cell.x + run.to + gutter);
      for (int y = low; y <= high; ++y) {
        Word* words = row(0, y);
        for (int x = from; x < to;) {
          const int end = std::min(to, (x / 64 + 1) * 64);
          const int count = end - x;
          const Word ones = count == 64 ? ~Word{0} : (Word{1} << count) - 1;
          words[x / 64] |= ones << (static_cast<unsigned>(x) % 64);
          x = end;
        }
      }
    }
  }
  const int low = std::max(0, cell.y - gutter);
  const int high = std::min(size_ - 1, cell.y + silhouette.height - 1 + gutter);
  for (int y = low; y <= high; ++y) refreshLevels(y);
}

void Bitmap::refreshLevels(int y) {
  std::vector<Word> next(words_);
  for (std::size_t level = 1; level < levels_; ++level) {
    const Word* below = row(level - 1, y);
    std::copy(below, below + words_, next.begin());
    const int shift = 1 << (level - 1);
    if (static_cast<std::size_t>(shift) / 64 < words_) orShifted(next, below, shift);
    std::copy(next.begin(), next.end(), row(level, y));
  }
}

}  // namespace opaline::atlas
