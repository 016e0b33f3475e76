#pragma once

#include <array>
#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "passes/variants.h"
#include "shaders/boundary/carry_fragments.comp.h"
#include "shaders/boundary/carry_vertices.comp.h"
#include "shaders/boundary/means.comp.h"
#include "shaders/boundary/patches.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Carries the results of boundary transport from clusters to vertices and visible pixels. It
/// corrects a half-space's exitance there by the mean difference that clusters have from it.
class CarryPass {
 public:
  explicit CarryPass(gpu::Device& device);

  /// Finds the patches of clusters.
  void recordPatches(gpu::CommandList& commands, Surfels& surfels, Clusters& clusters) const;

  /// The mean of the half-space's exitance over every cluster.
  enum class From : std::uint32_t { Vertices, Surfels, Patches };
  void recordMeans(gpu::CommandList& commands, From from, gpu::Buffer& exitances, Surfels& surfels,
                   Clusters& clusters) const;

  void overVertices(gpu::CommandList& commands, ScatterSite site, SceneTables& tables,
                    Clusters& clusters, const Places& vertices, gpu::Buffer& origins) const;
  /// For painted bodies, the exitance is that below the paint.
  void overFragments(gpu::CommandList& commands, SceneTables& tables, Clusters& clusters,
                     Asked asked, const SeenSurfaces& seen) const;

 private:
  gpu::Sampler nearest_;
  gpu::Compute<shaders::BoundaryPatches> patches_;
  std::array<gpu::Compute<shaders::BoundaryMeans>, 3> means_;  ///< indexed by From
  gpu::Compute<shaders::BoundaryCarryVertices> vertices_;
  Variants<shaders::BoundaryCarryFragments> fragments_;
};

}  // namespace opaline::passes
