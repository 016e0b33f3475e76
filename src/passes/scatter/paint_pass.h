#pragma once

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/paint/clusters.comp.h"
#include "shaders/paint/fragments.comp.h"
#include "shaders/paint/sources.comp.h"
#include "shaders/paint/surfels.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Absorbing layers on translucent bodies, which light crosses as it enters and as it leaves. In
/// between, boundary transport takes them from PaintTables::clusters.
class PaintPass {
 public:
  explicit PaintPass(gpu::Device& device);

  /// Makes the tables of surfels and clusters in PaintTables once the others exist. For set-up.
  void makeTables(gpu::Device& device, Surfels& surfels, Clusters& clusters, OpaqueTables& textures,
                  SceneTables& tables) const;

  /// Reduces the light that surfels have gathered to the part that passes the paint.
  void overSources(gpu::CommandList& commands, PaintTables& paint, Surfels& surfels) const;
  /// Turns the exitance below the paint of seen surfaces into what leaves through it. `carried`:
  /// CarryPass made it.
  void overFragments(gpu::CommandList& commands, SceneTables& tables, OpaqueTables& textures,
                     bool carried, const SeenSurfaces& seen) const;

 private:
  gpu::Sampler nearest_;
  gpu::Compute<shaders::PaintClusters> clusters_;
  gpu::Compute<shaders::PaintSurfels> surfels_;
  gpu::Compute<shaders::PaintSources> sources_;
  gpu::Compute<shaders::PaintFragments> fragments_;
};

}  // namespace opaline::passes
