#pragma once

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/gather/tilts.comp.h"
#include "shaders/shade/own_surfaces.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Roughness and normals that translucent bodies have of their own.
class OwnSurfacePass {
 public:
  explicit OwnSurfacePass(gpu::Device& device);

  /// Makes the normals of pieces by which light enters. For set-up.
  void makeTilts(gpu::Device& device, Surfels& surfels, OpaqueTables& textures,
                 SceneTables& tables) const;

  /// Leaves roughness and normal of translucent surfaces in VisibleSurfaces::materials. `roughness`
  /// is that of surfaces without their own.
  void record(gpu::CommandList& commands, SceneTables& tables, OpaqueTables& textures,
              float roughness, const SeenSurfaces& seen) const;

 private:
  gpu::Sampler nearest_;
  gpu::Compute<shaders::GatherTilts> tilts_;
  gpu::Compute<shaders::ShadeOwnSurfaces> seen_;
};

}  // namespace opaline::passes
