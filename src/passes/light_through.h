#pragma once

#include <cstdint>
#include <string>

#include "gpu/pipeline.h"
#include "passes/mechanics.h"
#include "passes/products.h"
#include "passes/variants.h"
#include "shaders/binding_groups.h"
#include "shaders/shared/boundary.h"

/// For passes whose shaders have lib/light_through.glsl.
namespace opaline::passes {

/// What lies between lights and opaque surfaces.
struct BodiesBetween {
  RayHierarchy& rays;
  Surfels& surfels;
  Clusters& clusters;
  bool letLightThrough;  ///< some of it, unscattered

  /// An upper bound of the loop rounds of an invocation that looks for one light behind them.
  std::uint32_t rounds() const {
    return letLightThrough ? shared::mostSurfacesOfWay * roundsOfWalk : 1;
  }
};

inline shaders::LightThrough lightThrough(const BodiesBetween& between, SceneTables& tables) {
  return {.pieceCorners = between.rays.corners,
          .rayHierarchy = rays(between.rays),
          .clusterPaints = tables.paint.clusters,
          .ranges = between.clusters.ranges,
          .clusterOfSurfel = between.clusters.clusterOfSurfel,
          .clusters = between.clusters.clusters};
}

/// Pipelines with and without light through bodies, and their paint.
template <typename Shader>
struct ThroughVariants {
  VariantsOfTwo<Shader> pipelines;

  ThroughVariants(gpu::Device& device, const std::string& name)
      : pipelines{{{device, name, {.withThinParts = 0, .withPaint = 0}},
                   {device, name, {.withThinParts = 0, .withPaint = 1}}},
                  {{device, name, {.withThinParts = 1, .withPaint = 0}},
                   {device, name, {.withThinParts = 1, .withPaint = 1}}}} {}

  const gpu::Compute<Shader>& of(const BodiesBetween& between, const SceneTables& tables) const {
    return pipelines.of(between.letLightThrough, between.letLightThrough && tables.paint.any);
  }
};

}  // namespace opaline::passes
