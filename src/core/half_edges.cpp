#include "core/half_edges.h"

#include <algorithm>

namespace opaline::core {

std::vector<HalfEdge> sortedHalfEdges(std::span<const Triangle> triangles) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint8_t c = 0; c < 3; ++c) {
      const std::uint32_t from = triangles[t][c];
      const std::uint32_t to = triangles[t][(c + 1U) % 3U];
      edges.push_back({std::min(from, to), std::max(from, to), t, c, from < to});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    if (a.low != b.low) return a.low < b.low;
    if (a.high != b.high) return a.high < b.high;
    return a.triangle < b.triangle;
  });
  return edges;
}

std::vector<Triangle> renamed(std::span<const Triangle> triangles,
                              std::span<const std::uint32_t> names) {
  std::vector<Triangle> result(triangles.size());
  std::transform(triangles.begin(), triangles.end(), result.begin(), [&](const Triangle& t) {
    return Triangle{names[t[0]], names[t[1]], names[t[2]]};
  });
  return result;
}

}  // namespace opaline::core
