#pragma once

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/shade/mirrored_scene.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// What opaque surfaces mirror of the scene, and how much of what they mirror is sky; and what
/// translucent surfaces mirror of bodies.
class MirroredScenePass {
 public:
  explicit MirroredScenePass(gpu::Device& device);

  struct Inputs {
    SceneTables& tables;
    Surfels& surfels;
    RayHierarchy& rays;
    Clusters& clusters;
    bool onTranslucent;  ///< VisibleSurfaces::light says how much of the sky these mirror
    bool insides;        ///< clusters know what leaves translucent bodies
    float roughness;     ///< of translucent surfaces that state none
  };
  /// Completes VisibleSurfaces::materials.
  void record(gpu::CommandList& commands, const Inputs& inputs, std::uint32_t firstRow,
              const SeenSurfaces& seen) const;

 private:
  gpu::Sampler nearest_;
  gpu::Compute<shaders::ShadeMirroredScene> pipeline_;
};

}  // namespace opaline::passes
