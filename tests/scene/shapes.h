#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/temporary_folder.h"
#include "opaline/scene.h"
#include "scene/raw_scene.h"

namespace opaline::test {

/// The surface of [0,1]³ plus an offset: 8 vertices, 12 triangles, facing outwards.
inline scene::RawMesh cube(const Vec3& at = {0, 0, 0}, float edge = 1) {
  scene::RawMesh mesh;
  for (unsigned i = 0; i < 8; ++i) {
    mesh.positions.push_back({at[0] + edge * static_cast<float>(i & 1U),
                              at[1] + edge * static_cast<float>((i >> 1U) & 1U),
                              at[2] + edge * static_cast<float>((i >> 2U) & 1U)});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

inline void append(scene::RawMesh& mesh, const scene::RawMesh& other) {
  const auto offset = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (const Triangle& t : other.triangles) {
    mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
}

/// The mesh with three separate vertices per triangle.
inline scene::RawMesh soup(const scene::RawMesh& mesh) {
  scene::RawMesh result;
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(result.positions.size());
    for (const std::uint32_t v : t) result.positions.push_back(mesh.positions[v]);
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

inline void turn(Triangle& t) {
  std::swap(t[1], t[2]);
}

/// Volume by the divergence theorem.
inline double signedVolume(const std::vector<Vec3>& p, const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const Triangle& t : triangles) {
    const Vec3& a = p[t[0]];
    const Vec3& b = p[t[1]];
    const Vec3& c = p[t[2]];
    sum += double{a[0]} * (double{b[1]} * c[2] - double{b[2]} * c[1]) +
           double{a[1]} * (double{b[2]} * c[0] - double{b[0]} * c[2]) +
           double{a[2]} * (double{b[0]} * c[1] - double{b[1]} * c[0]);
  }
  return sum / 6;
}

/// Counts the edges with more than two triangles, or with two that run the same way, by vertex
/// index.
std::size_t badEdges(const std::vector<Triangle>& triangles);

/// Expects valid indices, finite positions and normals, unit normals, no empty object, and
/// consistent nodes, tracks and rigs.
void expectSound(const Scene& scene);

inline std::size_t countOf(const std::vector<Repair>& repairs, const std::string& what) {
  for (const Repair& repair : repairs) {
    if (repair.what == what) return repair.count;
  }
  return 0;
}

}  // namespace opaline::test
