#include "paper/atlas/topology.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>

namespace opaline::atlas {
namespace {

/// Below this ratio of height to longest edge a triangle's shape is rounding noise of its floats.
constexpr double thinnest = 1e-5;

void weld(const core::RestSurface& surface, Topology& topology) {
  std::vector<std::uint32_t> order(surface.positionsMm.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Vec3& p = surface.positionsMm[a];
    const Vec3& q = surface.positionsMm[b];
    return std::tie(p, a) < std::tie(q, b);
  });
  std::vector<std::uint32_t> welded(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Vec3& p = surface.positionsMm[order[i]];
    if (i == 0 || p != surface.positionsMm[order[i - 1]]) {
      topology.positions.push_back({p[0], p[1], p[2]});
    }
    welded[order[i]] = static_cast<std::uint32_t>(topology.positions.size() - 1);
  }
  for (const Triangle& t : surface.triangles) {
    topology.triangles.push_back({welded[t[0]], welded[t[1]], welded[t[2]]});
  }
}

void measureTriangles(Topology& topology) {
  for (const Triangle& t : topology.triangles) {
    const Point3& a = topology.positions[t[0]];
    const Point3& b = topology.positions[t[1]];
    const Point3& c = topology.positions[t[2]];
    const Point3 n = cross(subtract(b, a), subtract(c, a));
    const double doubled = length(n);
    const double longest =
        std::max({length(subtract(b, a)), length(subtract(c, b)), length(subtract(a, c))});
    const bool isDegenerate = !(doubled > thinnest * longest * longest);
    topology.degenerate.push_back(isDegenerate);
    topology.areas.push_back(isDegenerate ? 0 : doubled / 2);
    topology.normals.push_back(
        isDegenerate ? Point3{} : Point3{n[0] / doubled, n[1] / doubled, n[2] / doubled});
    topology.centroids.push_back(
        {(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3, (a[2] + b[2] + c[2]) / 3});
  }
}

struct EdgeUse {
  std::uint32_t low, high;
  std::uint32_t object;
  std::uint32_t triangle;
  std::uint8_t edge;
  bool forwards;  // from low to high

  auto place() const { return std::tie(low, high, object); }
};

void connect(const core::RestSurface& surface, Topology& topology) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * topology.triangles.size());
  for (std::uint32_t t = 0; t < topology.triangles.size(); ++t) {
    if (topology.degenerate[t]) continue;
    for (std::uint8_t e = 0; e < 3; ++e) {
      const std::uint32_t a = topology.triangles[t][e];
      const std::uint32_t b = topology.triangles[t][(e + 1U) % 3];
      const std::uint32_t object =
          surface.objectOfTriangle.empty() ? 0 : surface.objectOfTriangle[t];
      uses.push_back({std::min(a, b), std::max(a, b), object, t, e, a < b});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.object, a.triangle, a.edge) <
           std::tie(b.low, b.high, b.object, b.triangle, b.edge);
  });
  topology.neighbours.assign(topology.triangles.size(), {none, none, none});
  for (std::size_t first = 0; first < uses.size();) {
    std::size_t last = first;
    while (last < uses.size() && uses[last].place() == uses[first].place()) ++last;
    const EdgeUse& a = uses[first];
    const EdgeUse& b = uses[last - 1];
    if (last - first == 2 && a.forwards != b.forwards && a.triangle != b.triangle) {
      topology.neighbours[a.triangle][a.edge] = b.triangle;
      topology.neighbours[b.triangle][b.edge] = a.triangle;
    }
    first = last;
  }
}

}  // namespace

Point3 subtract(const Point3& a, const Point3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Point3& a, const Point3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double length(const Point3& a) {
  return std::sqrt(dot(a, a));
}

Topology makeTopology(const core::RestSurface& surface) {
  Topology topology;
  weld(surface, topology);
  measureTriangles(topology);
  connect(surface, topology);
  return topology;
}

}  // namespace opaline::atlas
