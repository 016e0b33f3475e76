#include "scene/repair/manifold.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "core/disjoint_sets.h"
#include "scene/repair/topology.h"

namespace opaline::scene {

namespace {

bool isManifold(std::span<const HalfEdge> edge) {
  return edge.size() == 1 || (edge.size() == 2 && edge[0].forward != edge[1].forward);
}

/// Puts every corner into the set of its fan: the triangles around a point that are connected
/// through manifold edges.
core::DisjointSets fansOf(std::span<const HalfEdge> edges, std::size_t triangles) {
  core::DisjointSets fans(3 * triangles);
  const auto corner = [](const HalfEdge& half, std::uint32_t step) {
    return 3 * half.triangle + (half.corner + step) % 3;
  };
  forEachEdge(edges, [&](std::span<const HalfEdge> edge) {
    if (edge.size() != 2 || !isManifold(edge)) return;
    fans.join(corner(edge[0], 0), corner(edge[1], 1));
    fans.join(corner(edge[0], 1), corner(edge[1], 0));
  });
  return fans;
}

std::uint32_t copyVertex(RawMesh& mesh, std::uint32_t v) {
  mesh.positions.push_back(Vec3(mesh.positions[v]));
  if (!mesh.normals.empty()) mesh.normals.push_back(Vec3(mesh.normals[v]));
  if (!mesh.tags.empty()) mesh.tags.push_back(std::uint64_t{mesh.tags[v]});
  if (!mesh.provenance.empty()) mesh.provenance.push_back(Provenance(mesh.provenance[v]));
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

/// Gives every fan at a point of a cut edge its own vertices.
void separateFans(RawMesh& mesh, std::span<const std::uint32_t> points,
                  const std::vector<bool>& cutPoint, core::DisjointSets& fans) {
  struct Corner {
    std::uint32_t vertex, fan, name;
  };
  std::vector<Corner> corners;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint32_t c = 0; c < 3; ++c) {
      const std::uint32_t vertex = mesh.triangles[t][c];
      if (cutPoint[points[vertex]]) {
        corners.push_back({vertex, fans.find(3 * t + c), 3 * t + c});
      }
    }
  }
  std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
    if (a.vertex != b.vertex) return a.vertex < b.vertex;
    return a.fan != b.fan ? a.fan < b.fan : a.name < b.name;
  });
  std::uint32_t current = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i == 0 || corners[i].vertex != corners[i - 1].vertex) {
      current = corners[i].vertex;
    } else if (corners[i].fan != corners[i - 1].fan) {
      current = copyVertex(mesh, corners[i].vertex);
    }
    mesh.triangles[corners[i].name / 3][corners[i].name % 3] = current;
  }
}

/// Where one fan meets the same edge more than once, one pair of triangles keeps the edge and all
/// others are detached.
void detachRest(RawMesh& mesh) {
  const std::vector<HalfEdge> edges = sortedHalfEdges(mesh.triangles);
  forEachEdge(edges, [&](std::span<const HalfEdge> edge) {
    if (isManifold(edge)) return;
    const auto partner = std::find_if(edge.begin() + 1, edge.end(), [&](const HalfEdge& half) {
      return half.forward != edge[0].forward;
    });
    for (auto half = edge.begin() + 1; half != edge.end(); ++half) {
      if (half == partner) continue;
      Triangle& t = mesh.triangles[half->triangle];
      t[half->corner] = copyVertex(mesh, t[half->corner]);
      std::uint32_t& next = t[(half->corner + 1U) % 3U];
      next = copyVertex(mesh, next);
    }
  });
}

}  // namespace

std::size_t cutNonManifoldEdges(RawMesh& mesh, std::span<const std::uint32_t> points) {
  const std::vector<Triangle> surface = renamed(mesh.triangles, points);
  const std::vector<HalfEdge> edges = sortedHalfEdges(surface);
  std::vector<bool> cutPoint(mesh.positions.size());
  std::size_t cuts = 0;
  forEachEdge(edges, [&](std::span<const HalfEdge> edge) {
    if (isManifold(edge)) return;
    ++cuts;
    cutPoint[edge[0].low] = cutPoint[edge[0].high] = true;
  });
  if (cuts == 0) return 0;
  core::DisjointSets fans = fansOf(edges, surface.size());
  separateFans(mesh, points, cutPoint, fans);
  detachRest(mesh);
  return cuts;
}

}  // namespace opaline::scene
