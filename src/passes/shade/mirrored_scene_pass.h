#pragma once

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/shade/mirrored_scene.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Finds what opaque surfaces mirror of the scene, the share of sky in that, and what translucent
/// surfaces mirror of bodies.
class MirroredScenePass {
 public:
  explicit MirroredScenePass(gpu::Device& device);

  struct Inputs {
    SceneTables& tables;
    Surfels& surfels;
    RayHierarchy& rays;
    Clusters& clusters;
    bool onTranslucent;  ///< translucent surfaces take part; VisibleSurfaces::light has the share
                         ///< of sky that they mirror
    bool insides;        ///< clusters have the light that leaves translucent bodies; else they have
                         ///< half-spaces' means, which opaque surfaces mirror
    float roughness;     ///< of translucent surfaces without their own
  };
  /// Completes VisibleSurfaces::materials.
  void record(gpu::CommandList& commands, const Inputs& inputs, std::uint32_t firstRow,
              const SeenSurfaces& seen) const;

 private:
  gpu::Sampler nearest_;
  gpu::Compute<shaders::ShadeMirroredScene> pipeline_;
};

}  // namespace opaline::passes
