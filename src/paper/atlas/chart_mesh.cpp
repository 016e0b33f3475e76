#include "paper/atlas/chart_mesh.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

#include "core/disjoint_sets.h"

namespace opaline::atlas {
namespace {

std::uint32_t localIndex(const Chart& chart, std::uint32_t triangle) {
  const auto place = std::lower_bound(chart.begin(), chart.end(), triangle);
  return triangle == none || place == chart.end() || *place != triangle
             ? none
             : static_cast<std::uint32_t>(place - chart.begin());
}

std::uint32_t cornerOf(const Triangle& triangle, std::uint32_t vertex) {
  return triangle[0] == vertex ? 0U : triangle[1] == vertex ? 1U : 2U;
}

void traceLoops(ChartMesh& mesh) {
  std::vector<std::uint32_t> next(mesh.positions.size(), none);
  for (const auto& [a, b] : mesh.borders) next[a] = b;
  std::vector<std::pair<double, std::vector<std::uint32_t>>> loops;
  for (const auto& border : mesh.borders) {
    if (next[border[0]] == none) continue;
    double size = 0;
    std::vector<std::uint32_t> loop;
    for (std::uint32_t v = border[0]; next[v] != none;) {
      loop.push_back(v);
      const std::uint32_t following = std::exchange(next[v], none);
      size += length(subtract(mesh.positions[following], mesh.positions[v]));
      v = following;
    }
    loops.emplace_back(size, std::move(loop));
  }
  std::stable_sort(loops.begin(), loops.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  for (auto& loop : loops) mesh.loops.push_back(std::move(loop.second));
}

}  // namespace

ChartMesh extract(const Topology& topology, const Chart& chart) {
  ChartMesh mesh;
  const auto count = static_cast<std::uint32_t>(chart.size());
  core::DisjointSets corners(3 * chart.size());
  std::vector<std::array<std::uint32_t, 2>> borderCorners;
  std::size_t innerEdges = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Triangle& triangle = topology.triangles[chart[i]];
    for (std::uint32_t e = 0; e < 3; ++e) {
      const std::uint32_t next = (e + 1) % 3;
      const std::uint32_t other = localIndex(chart, topology.neighbours[chart[i]][e]);
      if (other == none) {
        borderCorners.push_back({3 * i + e, 3 * i + next});
        continue;
      }
      const Triangle& opposite = topology.triangles[chart[other]];
      corners.join(3 * i + e, 3 * other + cornerOf(opposite, triangle[e]));
      corners.join(3 * i + next, 3 * other + cornerOf(opposite, triangle[next]));
      ++innerEdges;
    }
  }
  std::vector<std::uint32_t> vertexOfCorner(3 * chart.size(), none);
  for (std::uint32_t c = 0; c < 3 * count; ++c) {
    const std::uint32_t root = corners.find(c);
    if (root == c) {
      vertexOfCorner[c] = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.push_back(topology.positions[topology.triangles[chart[c / 3]][c % 3]]);
    } else {
      vertexOfCorner[c] = vertexOfCorner[root];
    }
  }
  for (std::size_t i = 0; i < chart.size(); ++i) {
    mesh.triangles.push_back(
        {vertexOfCorner[3 * i], vertexOfCorner[3 * i + 1], vertexOfCorner[3 * i + 2]});
  }
  for (const auto& [a, b] : borderCorners) {
    mesh.borders.push_back({vertexOfCorner[a], vertexOfCorner[b]});
  }
  traceLoops(mesh);
  const auto edges = static_cast<int>(innerEdges / 2 + mesh.borders.size());
  const int euler = static_cast<int>(mesh.positions.size()) - edges + static_cast<int>(count);
  mesh.handles = (2 - static_cast<int>(mesh.loops.size()) - euler) / 2;
  return mesh;
}

}  // namespace opaline::atlas
