#include "scene/mesh/triangulate.h"

#include <cmath>

#include "scene/hash.h"

namespace opaline::scene {

namespace {

constexpr std::size_t mostSteps = 300'000'000;

/// Newell's method: the mean normal of any polygon, not of unit length.
Double3 polygonNormal(const RawMesh& mesh, std::span<const std::uint32_t> corners) {
  const Double3 origin = toDouble(mesh.positions[corners[0]]);
  Double3 normal{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Double3 a = toDouble(mesh.positions[corners[i]]) - origin;
    const Double3 b = toDouble(mesh.positions[corners[(i + 1) % corners.size()]]) - origin;
    normal = normal + cross(a, b);
  }
  return normal;
}

/// Projects along the axis on which the polygon's normal is longest, and keeps the turn.
Double2 flatten(const Double3& p, const Double3& normal) {
  const double x = std::abs(normal[0]);
  const double y = std::abs(normal[1]);
  const double z = std::abs(normal[2]);
  if (z >= x && z >= y) return {normal[2] > 0 ? p[0] : -p[0], p[1]};
  if (y >= x) return {normal[1] > 0 ? p[2] : -p[2], p[0]};
  return {normal[0] > 0 ? p[1] : -p[1], p[2]};
}

/// Whether every corner turns left and the polygon goes around once, so that no corner lies on the
/// wrong side of the fan.
bool isConvex(std::span<const Double2> p) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const std::size_t next = (i + 1) % p.size();
    if (turn(p[i], p[next], p[(i + 2) % p.size()]) < 0) return false;
    if (turn(p[0], p[i], p[next]) < 0) return false;
  }
  return true;
}

void addFan(RawMesh& mesh, std::span<const std::uint32_t> corners) {
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    mesh.triangles.push_back({corners[0], corners[i], corners[i + 1]});
  }
}

}  // namespace

bool Triangulator::clipEars(RawMesh& mesh, std::span<const std::uint32_t> corners) {
  const std::size_t before = mesh.triangles.size();
  const bool whole =
      ears_.clip(flat_, mostSteps, steps_, [&](const std::array<std::uint32_t, 3>& ear) {
        mesh.triangles.push_back({corners[ear[0]], corners[ear[1]], corners[ear[2]]});
      });
  if (!whole) mesh.triangles.resize(before);
  return whole;
}

void Triangulator::add(RawMesh& mesh, std::span<const std::uint32_t> corners) {
  ++mesh.polygons;
  mix(mesh.polygonHash, corners.size());
  for (const std::uint32_t v : corners) mix(mesh.polygonHash, v);
  if (corners.size() < 3) {
    ++mesh.badPolygons;
    return;
  }
  if (corners.size() > 3 && steps_ < mostSteps) {
    const Double3 normal = polygonNormal(mesh, corners);
    flat_.clear();
    for (const std::uint32_t v : corners) {
      flat_.push_back(flatten(toDouble(mesh.positions[v]), normal));
    }
    if (!isConvex(flat_) && clipEars(mesh, corners)) return;
  }
  addFan(mesh, corners);
}

}  // namespace opaline::scene
