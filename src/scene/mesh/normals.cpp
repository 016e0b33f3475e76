#include "scene/mesh/normals.h"

#include <algorithm>
#include <array>

#include "scene/vector_math.h"

namespace opaline::scene {

std::vector<Double3> smoothNormals(std::span<const Double3> positions,
                                   std::span<const Triangle> triangles) {
  std::vector<Double3> sums(positions.size());
  std::vector<Double3> normals(positions.size(), Double3{0, 0, 1});
  for (const Triangle& t : triangles) {
    const std::array<Double3, 3> corner{positions[t[0]], positions[t[1]], positions[t[2]]};
    const Double3 area = areaVector(corner[0], corner[1], corner[2]);
    const double size = length(area);
    if (!(size > 0)) continue;
    const Double3 normal = (1.0 / size) * area;
    for (std::size_t c = 0; c < 3; ++c) {
      const double angle = angleAt(corner[c], corner[(c + 1) % 3], corner[(c + 2) % 3]);
      sums[t[c]] = sums[t[c]] + angle * normal;
      normals[t[c]] = normal;  // keeps its value where opposite faces cancel
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const double size = length(sums[v]);
    if (size > 1e-6) normals[v] = (1.0 / size) * sums[v];
  }
  return normals;
}

std::vector<Vec3> smoothNormals(const RawMesh& mesh) {
  std::vector<Double3> positions(mesh.positions.size());
  std::transform(mesh.positions.begin(), mesh.positions.end(), positions.begin(),
                 [](const Vec3& p) { return toDouble(p); });
  const std::vector<Double3> smooth = smoothNormals(positions, mesh.triangles);
  std::vector<Vec3> normals(smooth.size());
  std::transform(smooth.begin(), smooth.end(), normals.begin(), toFloat);
  return normals;
}

std::size_t finishNormals(RawMesh& mesh, const std::vector<bool>& turned) {
  const std::vector<Vec3> smooth = smoothNormals(mesh);
  if (mesh.normals.empty()) {
    mesh.normals = smooth;
    return 0;
  }
  std::vector<bool> mayTurn(mesh.positions.size());
  for (std::size_t t = 0; t < turned.size(); ++t) {
    if (!turned[t]) continue;
    for (const std::uint32_t v : mesh.triangles[t]) mayTurn[v] = true;
  }
  std::size_t replaced = 0;
  for (std::size_t v = 0; v < smooth.size(); ++v) {
    Double3 normal = toDouble(mesh.normals[v]);
    const double size = length(normal);
    if (!isFinite(normal) || !(size > 1e-30)) {
      mesh.normals[v] = smooth[v];
      if (!mesh.provenance.empty()) mesh.provenance[v].normalSmooth = true;
      ++replaced;
      continue;
    }
    normal = (1.0 / size) * normal;
    if (mayTurn[v] && dot(normal, toDouble(smooth[v])) < 0) {
      normal = -1.0 * normal;
      if (!mesh.provenance.empty()) mesh.provenance[v].normalTurned ^= true;
    }
    mesh.normals[v] = toFloat(normal);
  }
  return replaced;
}

}  // namespace opaline::scene
