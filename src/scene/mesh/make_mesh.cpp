#include "opaline/mesh.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "opaline/error.h"
#include "scene/mesh/normals.h"

namespace opaline {

namespace {

void requireSound(const std::vector<Vec3>& positionsMm, const std::vector<Triangle>& triangles) {
  constexpr float farthest = 1e18F;
  for (std::size_t i = 0; i < positionsMm.size(); ++i) {
    for (const float x : positionsMm[i]) {
      if (std::abs(x) <= farthest) continue;
      throw UsageError(fmt::format(
          "The position of vertex {} has a coordinate of {}; it must be finite and within 1e18 mm.",
          i, x));
    }
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const std::uint32_t vertex : triangles[i]) {
      if (vertex < positionsMm.size()) continue;
      throw UsageError(fmt::format("Triangle {} names vertex {}, but there are {}.", i, vertex,
                                   positionsMm.size()));
    }
  }
}

}  // namespace

Mesh makeMesh(std::vector<Vec3> positionsMm, std::vector<Triangle> triangles) {
  requireSound(positionsMm, triangles);
  std::vector<scene::Double3> positions;
  positions.reserve(positionsMm.size());
  for (const Vec3& position : positionsMm) positions.push_back(scene::toDouble(position));
  Mesh mesh;
  mesh.normals.reserve(positions.size());
  for (const scene::Double3& normal : scene::smoothNormals(positions, triangles)) {
    mesh.normals.push_back(scene::toFloat(normal));
  }
  mesh.positionsMm = std::move(positionsMm);
  mesh.triangles = std::move(triangles);
  return mesh;
}

}  // namespace opaline
