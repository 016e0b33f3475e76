#include "boundary/pair_sums.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace opaline::test::boundary {

using namespace reference;

namespace {

constexpr double fourPi = 4 * std::numbers::pi;

double fluenceOfPair(const Vector& offset, double radiusMm, const Diffusion& medium) {
  const double r = std::sqrt(dot(offset, offset) + radiusMm * radiusMm / 4);
  return std::exp(-medium.attenuationPerMm * r) / (fourPi * medium.diffusionMm * r);
}

// e^{−σ_t' r} μ (1 − F_in(μ)) / (4πr²)
double unscatteredOfPair(const Vector& offset, const Cluster& at, const Diffusion& medium) {
  const double squared = dot(offset, offset) + at.discRadiusMm * at.discRadiusMm / 4;
  const double r = std::sqrt(squared);
  const double cosine = std::min(1.0, -dot(offset, at.normal) / r);
  if (cosine <= std::sqrt(1 - 1 / (medium.eta * medium.eta))) return 0;
  return std::exp(-medium.extinctionPerMm * r) * cosine *
         (1 - reflectanceInside(medium.eta, cosine)) / (fourPi * squared);
}

// Mean fluence at a depth below the middle of a disc of unit irradiance.
double fluenceOfDisc(double z, double radiusMm, const Diffusion& medium) {
  const double far = std::hypot(z, radiusMm);
  const double sigma = medium.attenuationPerMm;
  if (sigma * far < 1e-6) return (far - z) / (2 * medium.diffusionMm);
  return (std::exp(-sigma * z) - std::exp(-sigma * far)) / (2 * medium.diffusionMm * sigma);
}

double unscatteredOfDisc(double z, double radiusMm, const Diffusion& medium) {
  const double lowest =
      std::max(z / std::hypot(z, radiusMm), std::sqrt(1 - 1 / (medium.eta * medium.eta)));
  constexpr int steps = 64;
  double sum = 0;
  for (int k = 0; k < steps; ++k) {
    const double cosine = lowest + (1 - lowest) * (k + 0.5) / steps;
    sum += std::exp(-medium.extinctionPerMm * z / cosine) *
           (1 - reflectanceInside(medium.eta, cosine));
  }
  return (1 - lowest) * sum / (2 * steps);
}

}  // namespace

Flux fluxOf(const std::vector<LightPoint>& points, std::span<const double> entering,
            const TriangleClusters& clusters) {
  Flux flux;
  for (const LightPoint& point : points) {
    const double power =
        entering[point.cluster] * clusters.list[point.cluster].areaMm2 * point.weight;
    if (power <= 0) continue;
    flux.x.push_back(point.placeMm[0]);
    flux.y.push_back(point.placeMm[1]);
    flux.z.push_back(point.placeMm[2]);
    flux.power.push_back(power);
  }
  return flux;
}

void addFluence(const Flux& flux, const TriangleClusters& clusters, const Diffusion& medium,
                std::span<double> sum) {
  const double sigma = medium.attenuationPerMm;
  tbb::parallel_for(std::size_t{0}, clusters.count(), [&](std::size_t i) {
    const Cluster& at = clusters.list[i];
    const double soft = at.discRadiusMm * at.discRadiusMm / 4;
    double here = 0;
    for (std::size_t p = 0; p < flux.power.size(); ++p) {
      const double dx = flux.x[p] - at.centroidMm[0];
      const double dy = flux.y[p] - at.centroidMm[1];
      const double dz = flux.z[p] - at.centroidMm[2];
      const double r = std::sqrt(dx * dx + dy * dy + dz * dz + soft);
      here += flux.power[p] * std::exp(-sigma * r) / r;
    }
    sum[i] += here / (fourPi * medium.diffusionMm);
  });
}

void addUnscattered(const Flux& flux, const TriangleClusters& clusters, const Diffusion& medium,
                    std::span<double> sum) {
  const double reach = 14 / medium.extinctionPerMm;
  tbb::parallel_for(std::size_t{0}, clusters.count(), [&](std::size_t i) {
    const Cluster& at = clusters.list[i];
    double here = 0;
    for (std::size_t p = 0; p < flux.power.size(); ++p) {
      const Vector offset = Vector{flux.x[p], flux.y[p], flux.z[p]} - at.centroidMm;
      if (dot(offset, offset) > reach * reach) continue;
      here += flux.power[p] * unscatteredOfPair(offset, at, medium);
    }
    sum[i] += here;
  });
}

void correctOwnFluence(const std::vector<LightPoint>& points, std::span<const double> entering,
                       const TriangleClusters& clusters, const Diffusion& medium,
                       std::span<double> sum) {
  for (const LightPoint& point : points) {
    if (!point.direct || entering[point.cluster] <= 0) continue;
    const Cluster& own = clusters.list[point.cluster];
    const double pair =
        own.areaMm2 * fluenceOfPair(point.placeMm - own.centroidMm, own.discRadiusMm, medium);
    sum[point.cluster] += entering[point.cluster] * point.weight *
                          (fluenceOfDisc(point.depthMm, own.discRadiusMm, medium) - pair);
  }
}

void correctOwnUnscattered(const std::vector<LightPoint>& points, std::span<const double> entering,
                           const TriangleClusters& clusters, const Diffusion& medium,
                           std::span<double> sum) {
  for (const LightPoint& point : points) {
    if (!point.direct || entering[point.cluster] <= 0) continue;
    const Cluster& own = clusters.list[point.cluster];
    const double pair =
        own.areaMm2 * unscatteredOfPair(point.placeMm - own.centroidMm, own, medium);
    sum[point.cluster] += entering[point.cluster] * point.weight *
                          (unscatteredOfDisc(point.depthMm, own.discRadiusMm, medium) - pair);
  }
}

}  // namespace opaline::test::boundary
