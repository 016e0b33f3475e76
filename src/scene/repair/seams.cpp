#include "scene/repair/seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/repair/topology.h"
#include "scene/vector_math.h"

namespace opaline::scene {

namespace {

constexpr double nearness = 1e-6;  // of the extent

using Cell = std::array<std::int64_t, 3>;

/// Vertices on edges that only one triangle of the sewn surface has.
std::vector<std::uint32_t> verticesOnOpenEdges(const RawMesh& mesh,
                                               std::span<const std::uint32_t> points) {
  const std::vector<Triangle> surface = renamed(mesh.triangles, points);
  std::vector<bool> open(mesh.positions.size());
  forEachEdge(sortedHalfEdges(surface), [&](std::span<const HalfEdge> edge) {
    if (edge.size() == 1) open[edge[0].low] = open[edge[0].high] = true;
  });
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t v = 0; v < points.size(); ++v)
    if (open[points[v]]) vertices.push_back(v);
  return vertices;
}

double extentOf(const RawMesh& mesh) {
  Double3 low = toDouble(mesh.positions.front());
  Double3 high = low;
  for (const Vec3& position : mesh.positions) {
    const Double3 p = toDouble(position);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  return length(high - low);
}

/// Distinct places, no two of them near each other. They are found by cells as wide as what counts
/// as near.
class Places {
 public:
  Places(double within, const RawMesh& mesh, std::span<const std::uint32_t> vertices)
      : within_(within) {
    cells_.reserve(vertices.size());
    for (const std::uint32_t v : vertices) cells_.push_back(cellOf(mesh.positions[v]));
    std::sort(cells_.begin(), cells_.end());
    cells_.erase(std::unique(cells_.begin(), cells_.end()), cells_.end());
    places_.resize(cells_.size());
  }

  /// The place near a position. The position becomes a new place where there is none.
  Vec3 placeFor(const Vec3& position) {
    const Cell at = cellOf(position);
    const Vec3* near = nullptr;
    std::int64_t nearest = 27;  // order of the cell around that was found first
    for (int row = 0; row < 9; ++row) {
      const Cell begin{at[0] + row % 3 - 1, at[1] + row / 3 - 1, at[2] - 1};
      const Cell end{begin[0], begin[1], at[2] + 2};
      for (std::size_t cell = firstFrom(begin); cell < cells_.size() && cells_[cell] < end;
           ++cell) {
        const std::int64_t order = row + 9 * (cells_[cell][2] - begin[2]);
        const Vec3* found = order < nearest ? nearIn(cell, position) : nullptr;
        if (found == nullptr) continue;
        near = found;
        nearest = order;
      }
    }
    return near != nullptr ? *near : places_[firstFrom(at)].emplace_back(position);
  }

 private:
  Cell cellOf(const Vec3& position) const {
    Cell cell{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      cell[axis] = static_cast<std::int64_t>(std::floor(double{position[axis]} / within_));
    return cell;
  }

  std::size_t firstFrom(const Cell& cell) const {
    return static_cast<std::size_t>(std::lower_bound(cells_.begin(), cells_.end(), cell) -
                                    cells_.begin());
  }

  const Vec3* nearIn(std::size_t cell, const Vec3& position) const {
    for (const Vec3& place : places_[cell])
      if (length(toDouble(place) - toDouble(position)) <= within_) return &place;
    return nullptr;
  }

  double within_;
  std::vector<Cell> cells_;                ///< cells with vertices, ascending
  std::vector<std::vector<Vec3>> places_;  ///< in each of these cells
};

}  // namespace

std::size_t closeSeams(RawMesh& mesh, std::span<const std::uint32_t> points) {
  const std::vector<std::uint32_t> open = verticesOnOpenEdges(mesh, points);
  const double within = open.empty() ? 0 : nearness * extentOf(mesh);
  // Further out than this, neighbouring floats lie further apart than what counts as near.
  constexpr double largestCell = 1e15;
  double furthest = 0;
  for (const std::uint32_t v : open)
    furthest = std::max(furthest, length(toDouble(mesh.positions[v])));
  if (!(within > 0) || furthest / within > largestCell) return 0;
  Places places(within, mesh, open);
  std::size_t moved = 0;
  for (const std::uint32_t v : open) {
    const Vec3 place = places.placeFor(mesh.positions[v]);
    if (place == mesh.positions[v]) continue;
    mesh.positions[v] = place;
    ++moved;
  }
  return moved;
}

}  // namespace opaline::scene
