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

/// Absorbing layers on translucent bodies, which light crosses as it enters and as it leaves.
/// Between the two, boundary transport knows of them by PaintTables::clusters.
class PaintPass {
 public:
  explicit PaintPass(gpu::Device& device);

  /// What PaintTables has of surfels and clusters, once the rest of the tables is there. For
  /// set-up.
  void makeTables(gpu::Device& device, Surfels& surfels, Clusters& clusters, OpaqueTables& textures,
                  SceneTables& tables) const;

  /// Of light that surfels have gathered, leaves what gets in.
  void overSources(gpu::CommandList& commands, PaintTables& paint, Surfels& surfels) const;
  /// From the exitance that seen surfaces would have without a layer to leave through to what
  /// leaves. `carried`: by CarryPass.
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
