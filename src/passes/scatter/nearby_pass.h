#pragma once

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "passes/variants.h"
#include "shaders/scatter/nearby.comp.h"
#include "shaders/scatter/nearby_vertices.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Adds what sums over coarse surfels leave out nearby (singularity subtraction), for the objects
/// whose shared::ObjectData says that their surfels are coarse.
class NearbyPass {
 public:
  explicit NearbyPass(gpu::Device& device);

  struct Inputs {
    FrameView& frame;
    SceneTables& tables;
    ShadowMaps& shadows;
    Sky& sky;
    Surfels& surfels;
    OpaqueTables& textures;
  };
  void overPlaces(gpu::CommandList& commands, ScatterTransport transport, ScatterSite site,
                  const Inputs& inputs, const Places& places) const;
  void overFragments(gpu::CommandList& commands, ScatterTransport transport, ScatterSite site,
                     const Inputs& inputs, const SeenSurfaces& seen) const;

 private:
  struct Pipelines {
    gpu::Compute<shaders::ScatterNearbyVertices> vertices;
    Variants<shaders::ScatterNearby> fragments;  ///< indexed by normal textures
  };
  /// Variants without code for paint and with it.
  struct PerTransport {
    Pipelines plain;
    Pipelines painted;
  };
  static PerTransport makePipelines(gpu::Device& device, ScatterTransport transport);
  const Pipelines& pipelines(ScatterTransport transport, const SceneTables& tables) const {
    const PerTransport& of = transport == ScatterTransport::Dipole ? dipole_ : betterDipole_;
    return tables.paint.any ? of.painted : of.plain;
  }

  gpu::Sampler nearest_;
  gpu::Sampler linear_;
  PerTransport dipole_;
  PerTransport betterDipole_;
};

}  // namespace opaline::passes
