#include "boundary/clusters.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace opaline::test::boundary {

using namespace reference;

TriangleClusters clustersOf(const Geometry& geometry, std::span<const std::uint32_t> ofTriangle) {
  TriangleClusters clusters;
  clusters.ofTriangle.assign(ofTriangle.begin(), ofTriangle.end());
  const Body& body = geometry.scene().bodies.front();
  clusters.list.resize(1 + *std::max_element(ofTriangle.begin(), ofTriangle.end()));
  std::vector<Vector> middles;
  for (std::size_t t = 0; t < body.triangles.size(); ++t) {
    const Triangle& corners = body.triangles[t];
    const Vector& a = body.positionsMm[corners[0]];
    const Vector& b = body.positionsMm[corners[1]];
    const Vector& c = body.positionsMm[corners[2]];
    const Vector vectorArea = 0.5 * cross(b - a, c - a);
    const double area = length(vectorArea);
    Cluster& cluster = clusters.list[ofTriangle[t]];
    middles.push_back((1.0 / 3) * (a + b + c));
    cluster.areaMm2 += area;
    cluster.vectorAreaMm2 += vectorArea;
    cluster.centroidMm += area * middles.back();
  }
  for (Cluster& cluster : clusters.list) {
    cluster.centroidMm = (1 / cluster.areaMm2) * cluster.centroidMm;
    cluster.normal = unitOr(cluster.vectorAreaMm2, {0, 0, 1});
    cluster.discRadiusMm = std::sqrt(cluster.areaMm2 / std::numbers::pi);
  }
  std::vector<double> nearest(clusters.count(), std::numeric_limits<double>::infinity());
  constexpr double third = 1.0 / 3;
  for (std::uint32_t t = 0; t < body.triangles.size(); ++t) {
    Cluster& cluster = clusters.list[ofTriangle[t]];
    const double distance = length(middles[t] - cluster.centroidMm);
    if (distance >= nearest[ofTriangle[t]]) continue;
    nearest[ofTriangle[t]] = distance;
    cluster.start = geometry.pointOn(0, t, {third, third, third});
  }
  return clusters;
}

double coverage(const Cluster& of, const Vector& offset) {
  const double squared = dot(offset, offset);
  const double r = std::sqrt(squared);
  const double far = dot(offset, of.vectorAreaMm2) / (4 * std::numbers::pi * squared * r);
  // On its axis: 1/2 (1 - r/√(r² + ρ²)) instead of ρ²/(4r²).
  const double ratio = squared / (of.discRadiusMm * of.discRadiusMm);
  return far * 2 * ratio * (1 - std::sqrt(ratio / (1 + ratio)));
}

std::vector<double> insideOf(const TriangleClusters& clusters) {
  std::vector<double> inside(clusters.count(), 0);
  tbb::parallel_for(std::size_t{0}, clusters.count(), [&](std::size_t i) {
    double sum = 0;
    for (std::size_t j = 0; j < clusters.count(); ++j) {
      if (j == i) continue;
      const Vector offset = clusters.list[j].centroidMm - clusters.list[i].centroidMm;
      sum += coverage(clusters.list[j], offset);
    }
    inside[i] = sum;
  });
  return inside;
}

}  // namespace opaline::test::boundary
