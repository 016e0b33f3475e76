#pragma once

#include <cstddef>
#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "passes/variants.h"
#include "shaders/shade/opaque.comp.h"
#include "shaders/shade/shade.comp.h"
#include "shaders/shade/sum.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Turns exitance into radiance towards the camera and adds the reflection, for all surfaces that a
/// pixel sees.
class ShadePass {
 public:
  explicit ShadePass(gpu::Device& device);

  static gpu::GpuImage makeRadiance(gpu::Device& device, std::uint32_t width, std::uint32_t height);

  struct Inputs {
    SceneTables& tables;
    ShadowMaps& shadows;
    Exitance& exitance;
    Sky& sky;
    float roughness;
    bool atFragments;  ///< VisibleSurfaces::light has the exitance; else the vertices have it
    bool specular;
    bool mirrorsSky;     ///< VisibleSurfaces::light has the share
    bool mirrorsBodies;  ///< VisibleSurfaces::materials has their reflections
    bool leavesSmooth;   ///< light leaves as through a smooth surface, for any roughness
    bool byOrigin;  ///< bodies with an inside follow exitLaw(); VisibleSurfaces::origins or those
                    ///< of vertices are known
    bool seesThrough;  ///< VisibleSurfaces::materials has what is seen through thin parts
  };
  /// Leaves the radiance of translucent surfaces, times coverage, in VisibleSurfaces::light.
  void record(gpu::CommandList& commands, const Inputs& inputs, const SeenSurfaces& seen) const;
  /// The same for opaque surfaces, which record() does not change.
  void recordOpaque(gpu::CommandList& commands, const Inputs& inputs, OpaqueTables& opaque,
                    const SeenSurfaces& seen) const;
  /// Sums the surfaces of each pixel. Pixels that see nothing do not change.
  void sumUp(gpu::CommandList& commands, const SeenSurfaces& seen, gpu::GpuImage& radiance) const;

 private:
  gpu::Sampler nearest_;
  gpu::Sampler linear_;
  Variants<shaders::ShadeShade> shade_;  ///< this and the next indexed by paint
  Variants<shaders::ShadeShade> shadeOwnSurfaces_;
  gpu::Compute<shaders::ShadeOpaque> opaque_;
  gpu::Compute<shaders::ShadeSum> sum_;
};

}  // namespace opaline::passes
