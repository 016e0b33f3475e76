#include "boundary/reentry.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace opaline::test::boundary {

using namespace reference;

Reentry Reentry::ofPairs(const Geometry& geometry, const TriangleClusters& clusters,
                         const Diffusion& medium) {
  Reentry reentry;
  reentry.rows_.resize(clusters.count());
  tbb::parallel_for(std::size_t{0}, clusters.count(), [&](std::size_t i) {
    const Cluster& at = clusters.list[i];
    for (std::size_t j = 0; j < clusters.count(); ++j) {
      const Cluster& of = clusters.list[j];
      const Vector offset = of.centroidMm - at.centroidMm;
      const double r = length(offset);
      if (j == i || dot(offset, at.normal) <= 0 || dot(offset, of.normal) >= 0) continue;
      const Vector toStart = of.start.position - at.start.position;
      const double between = length(toStart);
      const Vector direction = (1 / between) * toStart;
      const auto hit = geometry.closestHit(at.start, direction);
      const bool seen = hit && (clusters.ofTriangle[hit->point.triangle] == j ||
                                hit->distanceMm > between * (1 - 1e-5));
      if (!seen || dot(direction, at.start.facetNormal) <= 0) continue;
      const double here = dot(offset, at.normal) / r;
      const double there = -dot(offset, of.normal) / r;
      const double factor = here * there * of.areaMm2 / (std::numbers::pi * r * r + of.areaMm2) *
                            (1 - reflectanceOutside(medium.eta, here)) *
                            (1 - reflectanceOutside(medium.eta, there)) / medium.meanTransmittance;
      reentry.rows_[i].push_back({static_cast<std::uint32_t>(j), static_cast<float>(factor)});
    }
  });
  return reentry;
}

Reentry Reentry::ofRays(const Geometry& geometry, const TriangleClusters& clusters,
                        const Diffusion& medium, int rays) {
  Reentry reentry;
  reentry.rows_.resize(clusters.count());
  tbb::parallel_for(std::size_t{0}, clusters.count(), [&](std::size_t i) {
    const Cluster& at = clusters.list[i];
    std::mt19937_64 random(i);
    std::uniform_real_distribution<double> uniform(0, 1);
    const double turn = uniform(random);
    const double shift = uniform(random);
    for (int k = 0; k < rays; ++k) {
      const double u = (k + shift) / rays;
      const double angle = 2 * std::numbers::pi * (turn + k * 0.6180339887498949);
      const Vector direction = around(at.normal, std::sqrt(1 - u), angle);
      if (dot(direction, at.start.facetNormal) <= 0) continue;
      const auto hit = geometry.closestHit(at.start, direction);
      if (!hit) continue;
      const double there = -dot(direction, hit->point.facetNormal);
      if (there <= 0) continue;
      const double factor = (1 - reflectanceOutside(medium.eta, std::sqrt(1 - u))) *
                            (1 - reflectanceOutside(medium.eta, std::min(1.0, there))) /
                            (medium.meanTransmittance * rays);
      reentry.rows_[i].push_back(
          {clusters.ofTriangle[hit->point.triangle], static_cast<float>(factor)});
    }
  });
  return reentry;
}

Reentry Reentry::ofSpreadRays(const Geometry& geometry, const TriangleClusters& clusters,
                              const Diffusion& medium, int rays) {
  Reentry reentry;
  reentry.rows_.resize(clusters.count());
  const Body& body = geometry.scene().bodies.front();
  std::vector<std::vector<std::uint32_t>> triangles(clusters.count());
  for (std::uint32_t t = 0; t < body.triangles.size(); ++t)
    triangles[clusters.ofTriangle[t]].push_back(t);
  tbb::parallel_for(std::size_t{0}, clusters.count(), [&](std::size_t i) {
    std::mt19937_64 random(i);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<double> areaSoFar;
    for (const std::uint32_t t : triangles[i]) {
      const Triangle& corners = body.triangles[t];
      const Vector& a = body.positionsMm[corners[0]];
      const double area =
          length(cross(body.positionsMm[corners[1]] - a, body.positionsMm[corners[2]] - a)) / 2;
      areaSoFar.push_back(area + (areaSoFar.empty() ? 0 : areaSoFar.back()));
    }
    const double turn = uniform(random);
    const double shift = uniform(random);
    std::vector<int> order(static_cast<std::size_t>(rays));
    for (int k = 0; k < rays; ++k) order[static_cast<std::size_t>(k)] = k;
    std::shuffle(order.begin(), order.end(), random);
    for (int k = 0; k < rays; ++k) {
      const double wanted =
          areaSoFar.back() * (order[static_cast<std::size_t>(k)] + uniform(random)) / rays;
      const auto found = std::lower_bound(areaSoFar.begin(), areaSoFar.end() - 1, wanted);
      const std::uint32_t triangle =
          triangles[i][static_cast<std::size_t>(found - areaSoFar.begin())];
      const double v = std::sqrt(uniform(random));
      const double w = uniform(random);
      const SurfacePoint start = geometry.pointOn(0, triangle, {1 - v, v * (1 - w), v * w});
      const double u = (k + shift) / rays;
      const double angle = 2 * std::numbers::pi * (turn + k * 0.6180339887498949);
      const Vector direction = around(start.facetNormal, std::sqrt(1 - u), angle);
      const auto hit = geometry.closestHit(start, direction);
      if (!hit) continue;
      const double there = -dot(direction, hit->point.facetNormal);
      if (there <= 0) continue;
      const double factor = (1 - reflectanceOutside(medium.eta, std::sqrt(1 - u))) *
                            (1 - reflectanceOutside(medium.eta, std::min(1.0, there))) /
                            (medium.meanTransmittance * rays);
      reentry.rows_[i].push_back(
          {clusters.ofTriangle[hit->point.triangle], static_cast<float>(factor)});
    }
  });
  return reentry;
}

std::vector<double> Reentry::entering(std::span<const double> exitance) const {
  std::vector<double> sum(rows_.size(), 0);
  for (std::size_t i = 0; i < rows_.size(); ++i)
    for (const Entry& entry : rows_[i]) sum[i] += entry.factor * exitance[entry.from];
  return sum;
}

std::size_t Reentry::entries() const {
  std::size_t count = 0;
  for (const auto& row : rows_) count += row.size();
  return count;
}

}  // namespace opaline::test::boundary
