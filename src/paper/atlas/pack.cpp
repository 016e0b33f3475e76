#include "paper/atlas/pack.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <thread>
#include <utility>

#include "paper/atlas/bitmap.h"
#include "paper/atlas/initial_map.h"

namespace opaline::atlas {
namespace {

constexpr int mostCells = 1024;  // of an edge of the bitmap, unless there are very many charts
constexpr int mostCellsCrowded = 4096;
constexpr double firstCoverage = .74;
constexpr double coveragePrecision = .006;
constexpr std::size_t fewCharts = 40;  // up to which many turns and orders are tried
constexpr int disturbedOrders = 16;

// After this many words of the bitmap are read, nothing better is looked for. Dozens of large
// charts or thousands of borders would take many seconds.
constexpr std::size_t enoughWork = 700'000'000;
constexpr std::size_t wordsPerPiece = 64;  // that take as long as one piece of a border

/// Andrew's monotone chain.
std::vector<Point2> convexHull(const Outline& outline) {
  std::vector<Point2> points;
  for (const auto& border : outline.borders) points.push_back(outline.places[border[0]]);
  std::sort(points.begin(), points.end());
  std::vector<Point2> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t start = hull.size();
    for (const Point2& p : points) {
      while (hull.size() >= start + 2 && !(signedArea(hull[hull.size() - 2], hull.back(), p) > 0)) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();  // the other side starts with it
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

struct Turn {
  double cosine, sine;
};

/// The turn that gives a chart the smallest box; one of the box's sides lies along the hull
/// (Freeman, Shapira 1975).
Turn smallestBox(const Outline& outline, double& longestSide) {
  const std::vector<Point2> hull = convexHull(outline);
  Turn best = {1, 0};
  double least = -1;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point2& a = hull[i];
    const Point2& b = hull[(i + 1) % hull.size()];
    const double size = std::hypot(b[0] - a[0], b[1] - a[1]);
    if (!(size > 0)) continue;
    const Turn turn = {(b[0] - a[0]) / size, -(b[1] - a[1]) / size};
    Point2 low = {1e300, 1e300};
    Point2 high = {-1e300, -1e300};
    for (const Point2& p : hull) {
      const Point2 q = {turn.cosine * p[0] - turn.sine * p[1],
                        turn.sine * p[0] + turn.cosine * p[1]};
      for (std::size_t axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], q[axis]);
        high[axis] = std::max(high[axis], q[axis]);
      }
    }
    const double area = (high[0] - low[0]) * (high[1] - low[1]);
    if (least >= 0 && area >= least) continue;
    least = area;
    best = turn;
    longestSide = std::max(high[0] - low[0], high[1] - low[1]);
  }
  return best;
}

class Packer {
 public:
  /// The order in which charts are laid out.
  enum class Order { Area, Extent };

  Packer(const std::vector<Outline>& outlines, int cells, int gutterCells, Order order)
      : outlines_(outlines), cells_(cells), gutter_(gutterCells) {
    for (const Outline& outline : outlines) {
      double longestSide = 0;
      boxes_.push_back(smallestBox(outline, longestSide));
      area_ += outline.area;
      longestSides_.push_back(longestSide);
      sizes_.push_back(order == Order::Area ? outline.area : longestSide);
    }
    const std::size_t count = outlines.size();
    turns_ = count <= fewCharts ? 16 : count <= 200 ? 8 : count <= 1000 ? 4 : 1;
  }

  std::optional<Layout> best() {
    const std::vector<std::size_t> order = ordered(sizes_);
    double works = firstCoverage;
    double fails = .98;
    std::optional<Layout> result = at(works, order);
    while (!result) {
      fails = works;
      works *= works > .5 ? .9 : .5;
      if (works < 1e-9) return std::nullopt;
      result = at(works, order);
    }
    while (fails - works > coveragePrecision && fails / works > 1.01 && hasWorkLeft()) {
      const double middle = (works + fails) / 2;
      if (auto layout = at(middle, order)) {
        result = std::move(layout);
        works = middle;
      } else {
        fails = middle;
      }
    }
    if (outlines_.size() > 1 && outlines_.size() <= fewCharts) improve(works, *result);
    return result;
  }

 private:
  struct Candidate {
    Turn turn{};
    Silhouette silhouette;
    Point2 corner{};
    Bitmap::Cell cell{};
    int middle2 = 0;
  };

  /// Largest first.
  static std::vector<std::size_t> ordered(const std::vector<double>& sizes) {
    std::vector<std::size_t> order(sizes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
    return order;
  }

  /// Tries randomly disturbed orders, each at a slightly larger scale than the last that worked.
  /// The generator's sequence is prescribed by the standard, so that every run agrees.
  void improve(double works, Layout& result) {
    std::minstd_rand random(1);
    for (int i = 0; i < disturbedOrders && !hasWorkedEnough(); ++i) {
      std::vector<double> sizes = sizes_;
      for (double& size : sizes) {
        size *= std::exp2(static_cast<double>(random()) / std::minstd_rand::max() - .5);
      }
      auto layout = at(works * (1 + coveragePrecision), ordered(sizes));
      if (!layout) continue;
      works *= 1 + coveragePrecision;
      result = std::move(*layout);
    }
  }

  /// A layout whose charts cover that part of the square, if they find room in that order.
  std::optional<Layout> at(double coverage, const std::vector<std::size_t>& order) {
    const double cellsPerMm = cells_ * std::sqrt(coverage / area_);
    if (leastCells(cellsPerMm) > (cells_ + gutter_) * static_cast<double>(cells_ + gutter_))
      return std::nullopt;
    workBefore_ = work_;
    Bitmap bitmap(cells_);
    Layout layout;
    layout.scale = cellsPerMm / cells_;
    layout.placements.resize(outlines_.size());
    LowestRows lowest(static_cast<std::size_t>(cells_) + 1, 0);
    for (const std::size_t chart : order) {
      const auto found = place(bitmap, chart, cellsPerMm, lowest);
      if (!found) return std::nullopt;
      bitmap.occupy(found->silhouette, found->cell, gutter_);
      layout.placements[chart] = {found->turn.cosine,
                                  found->turn.sine,
                                  {(found->cell.x - found->corner[0]) / cells_,
                                   (found->cell.y - found->corner[1]) / cells_}};
    }
    return layout;
  }

  /// How many cells the charts take at least, wherever they lie. With `gutter_` cells above and to
  /// the right of each of its own, no chart shares any with another.
  double leastCells(double cellsPerMm) const {
    const double upright = turns_ == 1 ? 1 : std::numbers::sqrt2 / 2;
    double sum = 0;
    for (std::size_t chart = 0; chart < outlines_.size(); ++chart) {
      const double length = cellsPerMm * longestSides_[chart];
      const double inside = cellsPerMm * cellsPerMm * outlines_[chart].area;
      sum += std::max(inside + gutter_ * (length + gutter_),
                      (std::max(1.0, upright * length) + gutter_) * (1 + gutter_));
    }
    return sum;
  }

  /// For tiny charts, by height: the row below which no room was left.
  using LowestRows = std::vector<int>;

  bool hasWorkedEnough() const { return work_ > enoughWork; }

  /// Whether another layout may be tried. Those of thousands of charts are not cut short, so they
  /// count ahead.
  bool hasWorkLeft() const {
    return turns_ == 1 ? 2 * work_ - workBefore_ <= enoughWork : !hasWorkedEnough();
  }

  std::optional<Candidate> place(const Bitmap& bitmap, std::size_t chart, double cellsPerMm,
                                 LowestRows& lowest) {
    std::optional<Candidate> best;
    for (int i = 0; i < turns_ && !(best && hasWorkedEnough()); ++i) {
      Candidate candidate;
      candidate.turn = turned(boxes_[chart], i);
      auto silhouette = silhouetteOf(outlines_[chart], candidate.turn.cosine, candidate.turn.sine,
                                     cellsPerMm, cells_, candidate.corner);
      if (!silhouette) continue;
      candidate.silhouette = std::move(*silhouette);
      work_ += wordsPerPiece * candidate.silhouette.pieces;
      const int height = candidate.silhouette.height;
      const bool isCrowded = turns_ == 1;
      int& lowestRow = lowest[static_cast<std::size_t>(height)];
      const auto cell = bitmap.findRoom(candidate.silhouette, isCrowded ? lowestRow : 0,
                                        best ? (best->middle2 - 1 + height) / 2 : cells_, work_);
      if (!cell) continue;
      if (isCrowded) lowestRow = cell->y;
      candidate.cell = *cell;
      candidate.middle2 = 2 * cell->y + height;
      best = std::move(candidate);
    }
    return best;
  }

  /// The box upright and lying, both ways up, then by ever smaller parts of a turn between.
  static Turn turned(const Turn& turn, int i) {
    constexpr std::array<int, 16> sixteenths = {0, 4, 8, 12, 2, 6,  10, 14,
                                                1, 3, 5, 7,  9, 11, 13, 15};
    const double angle = sixteenths[static_cast<std::size_t>(i)] * std::numbers::pi / 8;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {turn.cosine * c - turn.sine * s, turn.sine * c + turn.cosine * s};
  }

  const std::vector<Outline>& outlines_;
  int cells_;
  int gutter_;
  int turns_;
  double area_ = 0;
  std::size_t work_ = 0;
  std::size_t workBefore_ = 0;  // when the last layout was tried
  std::vector<Turn> boxes_;
  std::vector<double> longestSides_;  // mm, of those boxes
  std::vector<double> sizes_;
};

/// Both orders at once, on two threads.
std::optional<Layout> bestOfOrders(const std::vector<Outline>& outlines, int cells,
                                   int gutterCells) {
  std::optional<Layout> byArea;
  std::optional<Layout> byExtent;
  {
    const std::jthread other(
        [&] { byExtent = Packer(outlines, cells, gutterCells, Packer::Order::Extent).best(); });
    byArea = Packer(outlines, cells, gutterCells, Packer::Order::Area).best();
  }
  return !byArea || (byExtent && byExtent->scale > byArea->scale) ? byExtent : byArea;
}

/// One chart in each cell of a regular grid.
Layout packInGrid(const std::vector<Outline>& outlines) {
  const auto columns =
      static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(outlines.size()))));
  const double cell = 1 / static_cast<double>(columns);
  double extent = 0;
  std::vector<Point2> corners;
  for (const Outline& outline : outlines) {
    Point2 low = outline.places[outline.borders.front()[0]];
    Point2 high = low;
    for (const auto& border : outline.borders) {
      for (std::size_t i = 0; i < 2; ++i) {
        low[i] = std::min(low[i], outline.places[border[0]][i]);
        high[i] = std::max(high[i], outline.places[border[0]][i]);
      }
    }
    extent = std::max({extent, high[0] - low[0], high[1] - low[1]});
    corners.push_back(low);
  }
  Layout layout;
  layout.scale = .7 * cell / extent;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const std::size_t row = i / columns;
    const double x = (static_cast<double>(i - row * columns) + .15) * cell;
    const double y = (static_cast<double>(row) + .15) * cell;
    layout.placements.push_back(
        {1, 0, {x - layout.scale * corners[i][0], y - layout.scale * corners[i][1]}});
  }
  return layout;
}

}  // namespace

Layout pack(const std::vector<Outline>& outlines, int mapSize, int gutter) {
  if (outlines.empty()) return {};
  const int cells = std::min(mapSize, mostCells);
  const int gutterCells = (gutter * cells + mapSize - 1) / mapSize;
  const auto room = static_cast<double>(cells) * cells / ((1. + gutterCells) * (1. + gutterCells));
  if (static_cast<double>(outlines.size()) < .7 * room) {
    if (auto layout = bestOfOrders(outlines, cells, gutterCells)) return *layout;
  }
  // With too many charts for such gutters, a gutter becomes one cell of an ever finer bitmap.
  for (int fine = 4 * cells; fine <= mostCellsCrowded; fine *= 4) {
    if (static_cast<double>(outlines.size()) > .025 * fine * fine) continue;
    if (auto layout = Packer(outlines, fine, 1, Packer::Order::Area).best()) return *layout;
  }
  return packInGrid(outlines);
}

}  // namespace opaline::atlas
