#include "scene/repair/topology.h"

#include <algorithm>

#include "core/disjoint_sets.h"
#include "core/equal_positions.h"

namespace opaline::scene {

namespace {

/// A side without a partner, named by the places of its ends.
struct OpenSide {
  std::uint32_t lowPlace = 0;
  std::uint32_t highPlace = 0;
  std::uint32_t low = 0;
  std::uint32_t high = 0;
};

std::vector<OpenSide> openSides(std::span<const Triangle> triangles,
                                std::span<const std::uint32_t> places) {
  std::vector<OpenSide> open;
  forEachEdge(sortedHalfEdges(triangles), [&](std::span<const HalfEdge> edge) {
    if (edge.size() != 1) return;
    OpenSide side{places[edge[0].low], places[edge[0].high], edge[0].low, edge[0].high};
    if (side.lowPlace > side.highPlace) {
      std::swap(side.lowPlace, side.highPlace);
      std::swap(side.low, side.high);
    }
    open.push_back(side);
  });
  std::sort(open.begin(), open.end(), [](const OpenSide& a, const OpenSide& b) {
    return a.lowPlace != b.lowPlace ? a.lowPlace < b.lowPlace : a.highPlace < b.highPlace;
  });
  return open;
}

}  // namespace

std::vector<std::uint32_t> sewn(std::span<const Vec3> positions,
                                std::span<const Triangle> triangles) {
  const std::vector<std::uint32_t> places = core::equalPositions(positions);
  const std::vector<OpenSide> open = openSides(triangles, places);
  core::DisjointSets sets(positions.size());
  for (std::size_t i = 1; i < open.size(); ++i) {
    if (open[i].lowPlace == open[i - 1].lowPlace && open[i].highPlace == open[i - 1].highPlace) {
      sets.join(open[i].low, open[i - 1].low);
      sets.join(open[i].high, open[i - 1].high);
    }
  }
  std::vector<std::uint32_t> names(positions.size());
  for (std::uint32_t v = 0; v < names.size(); ++v) names[v] = sets.find(v);
  return names;
}

namespace {

std::uint32_t cornerName(std::uint32_t triangle, std::uint32_t corner) {
  return 3 * triangle + corner % 3;
}

}  // namespace

// A fan is the corners around one vertex that are connected through triangles. Two boundary sides
// belong to one loop when they share a fan.
Borders bordersOf(std::span<const Triangle> triangles, std::span<const HalfEdge> edges) {
  core::DisjointSets corners(3 * triangles.size());
  forEachEdge(edges, [&](std::span<const HalfEdge> edge) {
    if (edge.size() != 2) return;
    const auto [t0, c0] = std::pair{edge[0].triangle, std::uint32_t{edge[0].corner}};
    const auto [t1, c1] = std::pair{edge[1].triangle, std::uint32_t{edge[1].corner}};
    const bool opposed = edge[0].forward != edge[1].forward;
    corners.join(cornerName(t0, c0), cornerName(t1, opposed ? c1 + 1 : c1));
    corners.join(cornerName(t0, c0 + 1), cornerName(t1, opposed ? c1 : c1 + 1));
  });
  core::DisjointSets loops(3 * triangles.size());
  std::vector<std::uint32_t> starts;
  forEachEdge(edges, [&](std::span<const HalfEdge> edge) {
    if (edge.size() != 1) return;
    const std::uint32_t from = corners.find(cornerName(edge[0].triangle, edge[0].corner));
    const std::uint32_t to = corners.find(cornerName(edge[0].triangle, edge[0].corner + 1U));
    loops.join(from, to);
    starts.push_back(from);
  });
  Borders borders{.sides = starts.size()};
  for (std::uint32_t& start : starts) start = loops.find(start);
  std::sort(starts.begin(), starts.end());
  borders.loops =
      static_cast<std::size_t>(std::unique(starts.begin(), starts.end()) - starts.begin());
  return borders;
}

}  // namespace opaline::scene
