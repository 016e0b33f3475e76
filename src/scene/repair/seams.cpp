#include "scene/repair/seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include "scene/repair/topology.h"
#include "scene/vector_math.h"

namespace opaline::scene {

namespace {

constexpr double nearness = 1e-6;  // of the extent

using Cell = std::array<std::int64_t, 3>;

/// On edges of one triangle of the sewn surface.
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

/// Places so far apart that each is one, by cells as wide as what counts as near.
class Places {
 public:
  explicit Places(double within) : within_(within) {}

  /// The place that is near, which this becomes where there is none.
  const Vec3& placeFor(const Vec3& position) {
    const Cell at = cellOf(position);
    for (int i = 0; i < 27; ++i) {
      const auto found =
          places_.find({at[0] + i % 3 - 1, at[1] + i / 3 % 3 - 1, at[2] + i / 9 - 1});
      if (found == places_.end()) continue;
      for (const Vec3& place : found->second)
        if (length(toDouble(place) - toDouble(position)) <= within_) return place;
    }
    return places_[at].emplace_back(position);
  }

 private:
  Cell cellOf(const Vec3& position) const {
    Cell cell{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      cell[axis] = static_cast<std::int64_t>(std::floor(double{position[axis]} / within_));
    return cell;
  }

  double within_;
  std::map<Cell, std::vector<Vec3>> places_;
};

}  // namespace

std::size_t closeSeams(RawMesh& mesh, std::span<const std::uint32_t> points) {
  const std::vector<std::uint32_t> open = verticesOnOpenEdges(mesh, points);
  const double within = open.empty() ? 0 : nearness * extentOf(mesh);
  // Further out than that from the origin, neighbouring floats are further apart.
  constexpr double largestCell = 1e15;
  double furthest = 0;
  for (const std::uint32_t v : open)
    furthest = std::max(furthest, length(toDouble(mesh.positions[v])));
  if (!(within > 0) || furthest / within > largestCell) return 0;
  Places places(within);
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
