#include "scene/mesh/insides.h"

#include <cstdint>
#include <numbers>

#include "core/disjoint_sets.h"
#include "scene/repair/topology.h"
#include "scene/vector_math.h"

namespace opaline::scene {

namespace {

// How large a part's holes may be, relative to its surface, for it to count as closed.
constexpr double largestHoles = 0.05;

double distance(const Vec3& a, const Vec3& b) {
  return length(toDouble(a) - toDouble(b));
}

double areaOf(std::span<const Vec3> positions, const Triangle& t) {
  return length(areaVector(toDouble(positions[t[0]]), toDouble(positions[t[1]]),
                           toDouble(positions[t[2]]))) /
         2;
}

}  // namespace

std::vector<bool> trianglesWithInside(std::span<const Vec3> positions,
                                      std::span<const Triangle> triangles) {
  const std::vector<Triangle> surface = renamed(triangles, sewn(positions, triangles));
  core::DisjointSets parts(positions.size());
  for (const Triangle& t : surface) {
    parts.join(t[0], t[1]);
    parts.join(t[0], t[2]);
  }
  std::vector<double> area(positions.size(), 0);
  for (const Triangle& t : surface) area[parts.find(t[0])] += areaOf(positions, t);
  // Border sides that are connected bound one hole.
  const std::vector<HalfEdge> edges = sortedHalfEdges(surface);
  core::DisjointSets borders(positions.size());
  forEachEdge(edges, [&](std::span<const HalfEdge> edge) {
    if (edge.size() == 1) borders.join(edge[0].low, edge[0].high);
  });
  std::vector<double> lengths(positions.size(), 0);
  forEachEdge(edges, [&](std::span<const HalfEdge> edge) {
    if (edge.size() == 1)
      lengths[borders.find(edge[0].low)] +=
          distance(positions[edge[0].low], positions[edge[0].high]);
  });
  std::vector<double> holes(positions.size(), 0);
  for (std::uint32_t v = 0; v < lengths.size(); ++v)
    // A circle encloses the largest area, so no flat hole with this border is larger.
    holes[parts.find(v)] += lengths[v] * lengths[v] / (4 * std::numbers::pi);
  std::vector<bool> inside;
  inside.reserve(surface.size());
  for (const Triangle& t : surface) {
    const std::uint32_t part = parts.find(t[0]);
    inside.push_back(area[part] > 0 && holes[part] <= largestHoles * area[part]);
  }
  return inside;
}

}  // namespace opaline::scene
