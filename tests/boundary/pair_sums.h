#pragma once

#include <span>
#include <vector>

#include "boundary/channel.h"
#include "boundary/clusters.h"
#include "boundary/light_points.h"

namespace opaline::test::boundary {

/// Points of light and their fluxes.
struct Flux {
  std::vector<double> x, y, z, power;
};

/// The fluxes of points whose cluster lets light in; `entering` is irradiance per cluster.
Flux fluxOf(const std::vector<LightPoint>& points, std::span<const double> entering,
            const TriangleClusters& clusters);

/// Σ power e^{−σr}/(4πDr) at every cluster, added to `sum`; r² = distance² + ρ²/4.
void addFluence(const Flux& flux, const TriangleClusters& clusters, const Diffusion& medium,
                std::span<double> sum);

/// Adds the light of these points that leaves without another collision, per area.
void addUnscattered(const Flux& flux, const TriangleClusters& clusters, const Diffusion& medium,
                    std::span<double> sum);

/// A cluster's own points of segment 0 are discs: replaces the pair sums' result for them.
void correctOwnFluence(const std::vector<LightPoint>& points, std::span<const double> entering,
                       const TriangleClusters& clusters, const Diffusion& medium,
                       std::span<double> sum);
void correctOwnUnscattered(const std::vector<LightPoint>& points, std::span<const double> entering,
                           const TriangleClusters& clusters, const Diffusion& medium,
                           std::span<double> sum);

}  // namespace opaline::test::boundary
