#include "paper/atlas/border.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "paper/atlas/initial_map.h"

namespace opaline::atlas {
namespace {

bool segmentsMeet(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const double abc = signedArea(a, b, c);
  const double abd = signedArea(a, b, d);
  const double cda = signedArea(c, d, a);
  const double cdb = signedArea(c, d, b);
  if (abc == 0 && abd == 0) {  // on one line: they meet if their boxes do
    for (std::size_t i = 0; i < 2; ++i) {
      if (std::max(a[i], b[i]) < std::min(c[i], d[i])) return false;
      if (std::max(c[i], d[i]) < std::min(a[i], b[i])) return false;
    }
    return true;
  }
  return abc * abd <= 0 && cda * cdb <= 0;
}

/// Border edges by the cells of a grid that their boxes touch.
class EdgeGrid {
 public:
  EdgeGrid(const ChartMesh& mesh, const std::vector<Point2>& places)
      : mesh_(mesh), places_(places) {
    low_ = high_ = places[mesh.borders.front()[0]];
    double total = 0;
    for (const auto& [a, b] : mesh.borders) {
      for (std::size_t i = 0; i < 2; ++i) {
        low_[i] = std::min(low_[i], places[a][i]);
        high_[i] = std::max(high_[i], places[a][i]);
      }
      total += std::hypot(places[a][0] - places[b][0], places[a][1] - places[b][1]);
    }
    const double mean = total / static_cast<double>(mesh.borders.size());
    const double extent = std::max(high_[0] - low_[0], high_[1] - low_[1]);
    cell_ = std::max(mean, extent / mostCells);
    if (!(cell_ > 0)) cell_ = 1;
    for (std::size_t i = 0; i < 2; ++i) {
      size_[i] = 1 + static_cast<std::size_t>((high_[i] - low_[i]) / cell_);
    }
    edges_.resize(size_[0] * size_[1]);
  }

  /// Adds an edge; true if it meets one that is there already.
  bool addMeets(std::uint32_t edge) {
    const auto& [a, b] = mesh_.borders[edge];
    const auto [fromX, toX] = range(a, b, 0);
    const auto [fromY, toY] = range(a, b, 1);
    for (std::size_t y = fromY; y <= toY; ++y) {
      for (std::size_t x = fromX; x <= toX; ++x) {
        auto& here = edges_[y * size_[0] + x];
        for (const std::uint32_t other : here) {
          const auto& [c, d] = mesh_.borders[other];
          if (a == c || a == d || b == c || b == d) continue;
          if (segmentsMeet(places_[a], places_[b], places_[c], places_[d])) return true;
        }
        here.push_back(edge);
      }
    }
    return false;
  }

 private:
  static constexpr double mostCells = 512;

  std::array<std::size_t, 2> range(std::uint32_t a, std::uint32_t b, std::size_t axis) const {
    const double from = std::min(places_[a][axis], places_[b][axis]) - low_[axis];
    const double to = std::max(places_[a][axis], places_[b][axis]) - low_[axis];
    return {static_cast<std::size_t>(from / cell_), static_cast<std::size_t>(to / cell_)};
  }

  const ChartMesh& mesh_;
  const std::vector<Point2>& places_;
  Point2 low_{};
  Point2 high_{};
  double cell_ = 1;
  std::array<std::size_t, 2> size_{};
  std::vector<std::vector<std::uint32_t>> edges_;
};

bool bordersCross(const ChartMesh& mesh, const std::vector<Point2>& places) {
  EdgeGrid grid(mesh, places);
  for (std::uint32_t e = 0; e < mesh.borders.size(); ++e) {
    if (grid.addMeets(e)) return true;
  }
  return false;
}

bool runsCounterClockwise(const std::vector<std::uint32_t>& loop,
                          const std::vector<Point2>& places) {
  double area = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    area += signedArea(places[loop[0]], places[loop[i]], places[loop[i + 1]]);
  }
  return area > 0;
}

}  // namespace

bool isOneToOne(const ChartMesh& mesh, const std::vector<Point2>& places) {
  if (mesh.borders.empty()) return false;
  const auto outer = std::count_if(mesh.loops.begin(), mesh.loops.end(), [&](const auto& loop) {
    return runsCounterClockwise(loop, places);
  });
  return outer == 1 && !bordersCross(mesh, places);
}

}  // namespace opaline::atlas
