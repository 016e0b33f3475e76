#include "scene/repair/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/equal_positions.h"
#include "opaline/error.h"
#include "scene/mesh/normals.h"
#include "scene/repair/manifold.h"
#include "scene/repair/orientation.h"
#include "scene/repair/seams.h"
#include "scene/repair/topology.h"
#include "scene/vector_math.h"

namespace opaline::scene {

namespace {

constexpr std::uint32_t noVertex = 0xFFFFFFFFU;

void requireFinite(const RawMesh& mesh, const std::string& object) {
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (!isFinite(mesh.positions[v])) {
      throw Error(fmt::format("{}: the position of vertex {} is not finite", object, v));
    }
  }
}

std::size_t countUnused(const RawMesh& mesh) {
  std::vector<bool> used(mesh.positions.size());
  for (const Triangle& t : mesh.triangles) used[t[0]] = used[t[1]] = used[t[2]] = true;
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
}

/// Whether the height is below 1e-12 of the longest side: double precision cannot tell a normal
/// then.
bool isDegenerate(const RawMesh& mesh, const Triangle& t) {
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
  const Double3 a = toDouble(mesh.positions[t[0]]);
  const Double3 b = toDouble(mesh.positions[t[1]]);
  const Double3 c = toDouble(mesh.positions[t[2]]);
  const double longest = std::max({length(b - a), length(c - b), length(a - c)});
  return !(length(areaVector(a, b, c)) > 1e-12 * longest * longest);
}

std::size_t removeDegenerate(RawMesh& mesh) {
  return std::erase_if(mesh.triangles, [&](const Triangle& t) { return isDegenerate(mesh, t); });
}

Vec3 normalOf(const RawMesh& mesh, std::uint32_t v) {
  const Vec3 none{0, 0, 0};
  return mesh.normals.empty() || !isFinite(mesh.normals[v]) ? none : mesh.normals[v];
}

/// Merges vertices that are one point of the surface and agree in everything else.
std::size_t mergeDuplicates(RawMesh& mesh, std::span<const std::uint32_t> points) {
  std::vector<std::uint32_t> order(mesh.positions.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  const auto key = [&](std::uint32_t v) {
    return std::tuple(points[v], normalOf(mesh, v), mesh.tags.empty() ? 0U : mesh.tags[v]);
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (points[a] != points[b]) return points[a] < points[b];
    const auto keyA = key(a);
    const auto keyB = key(b);
    return keyA != keyB ? keyA < keyB : a < b;
  });
  std::vector<std::uint32_t> first(mesh.positions.size());
  std::size_t merged = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
    first[order[i]] = same ? first[order[i - 1]] : order[i];
    merged += same ? 1U : 0U;
  }
  if (merged > 0) mesh.triangles = renamed(mesh.triangles, first);
  return merged;
}

/// The triangle with its smallest corner first; the turn is kept.
Triangle rotated(const Triangle& t) {
  if (t[0] <= t[1] && t[0] <= t[2]) return t;
  if (t[1] <= t[0] && t[1] <= t[2]) return {t[1], t[2], t[0]};
  return {t[2], t[0], t[1]};
}

/// Keeps only the first of triangles with equal keys.
std::size_t keepFirst(std::vector<Triangle>& triangles, const std::vector<Triangle>& keys) {
  std::vector<std::uint32_t> order(triangles.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return keys[a] != keys[b] ? keys[a] < keys[b] : a < b;
  });
  std::vector<bool> drop(triangles.size());
  for (std::size_t i = 1; i < order.size(); ++i) {
    drop[order[i]] = keys[order[i]] == keys[order[i - 1]];
  }
  std::size_t index = 0;
  return std::erase_if(triangles, [&](const Triangle&) { return drop[index++]; });
}

std::size_t removeDuplicateFaces(RawMesh& mesh, std::span<const std::uint32_t> points) {
  std::vector<Triangle> keys = renamed(mesh.triangles, core::equalPositions(mesh.positions));
  std::transform(keys.begin(), keys.end(), keys.begin(), rotated);
  std::size_t removed = keepFirst(mesh.triangles, keys);
  // The two faces of a leaf without thickness would cancel each other's normals.
  keys = renamed(mesh.triangles, points);
  for (Triangle& key : keys) std::sort(key.begin(), key.end());
  removed += keepFirst(mesh.triangles, keys);
  return removed;
}

template <typename T>
void keepUsed(std::vector<T>& values, std::span<const std::uint32_t> newIndex) {
  if (values.empty()) return;
  std::size_t kept = 0;
  for (std::size_t v = 0; v < newIndex.size(); ++v) {
    if (newIndex[v] != noVertex) values[kept++] = values[v];
  }
  values.resize(kept);
}

void dropUnused(RawMesh& mesh) {
  std::vector<std::uint32_t> newIndex(mesh.positions.size(), noVertex);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) newIndex[v] = 0;
  }
  std::uint32_t next = 0;
  for (std::uint32_t& index : newIndex) {
    if (index != noVertex) index = next++;
  }
  if (next == newIndex.size()) return;
  keepUsed(mesh.positions, newIndex);
  keepUsed(mesh.normals, newIndex);
  keepUsed(mesh.tags, newIndex);
  keepUsed(mesh.provenance, newIndex);
  mesh.triangles = renamed(mesh.triangles, newIndex);
}

}  // namespace

void addRepair(std::vector<Repair>& repairs, const std::string& what, std::size_t count) {
  if (count == 0) return;
  const auto known = std::find_if(repairs.begin(), repairs.end(),
                                  [&](const Repair& repair) { return repair.what == what; });
  if (known == repairs.end()) {
    repairs.push_back({what, count});
  } else {
    known->count += count;
  }
}

std::vector<Repair> repairMesh(RawMesh& mesh, const std::string& object) {
  requireFinite(mesh, object);
  std::vector<Repair> repairs;
  const bool hadFaces = !mesh.triangles.empty() || mesh.badPolygons > 0;
  addRepair(repairs, "unused vertices", countUnused(mesh));
  addRepair(repairs, "degenerate triangles", mesh.badPolygons + removeDegenerate(mesh));
  if (mesh.triangles.empty()) {
    throw Error(hadFaces
                    ? fmt::format("{}: every face is degenerate, so there is no surface", object)
                    : fmt::format("{}: there is no face; only triangle meshes have a surface "
                                  "that can be rendered",
                                  object));
  }
  std::vector<std::uint32_t> points = sewn(mesh.positions, mesh.triangles);
  if (const std::size_t moved = closeSeams(mesh, points); moved > 0) {
    addRepair(repairs, "vertices beside their seam", moved);
    points = sewn(mesh.positions, mesh.triangles);
  }
  addRepair(repairs, "duplicate vertices", mergeDuplicates(mesh, points));
  addRepair(repairs, "duplicate faces", removeDuplicateFaces(mesh, points));
  dropUnused(mesh);
  points = sewn(mesh.positions, mesh.triangles);
  const OrientationResult orientation = orientOutward(mesh, points);
  addRepair(repairs, "inconsistent orientation", orientation.inconsistent);
  addRepair(repairs, "inward orientation", orientation.inward);
  addRepair(repairs, "non-manifold edges", cutNonManifoldEdges(mesh, points));
  addRepair(repairs, "unusable normals", finishNormals(mesh, orientation.turned));
  return repairs;
}

}  // namespace opaline::scene
