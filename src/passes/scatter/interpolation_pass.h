#pragma once

#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "passes/variants.h"
#include "shaders/scatter/interpolate.comp.h"
#include "shaders/scatter/knots.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Finds the visible surfaces that need a sum of their own. In blocks of 8×8 or 4×4 pixels that one
/// smooth surface fills, light is interpolated between knots if it changes evenly from each to the
/// next.
class InterpolationPass {
 public:
  explicit InterpolationPass(gpu::Device& device);

  struct Inputs {
    SceneTables& tables;
    Surfels& surfels;
    Exitance& exitance;
    std::uint32_t firstRow;  ///< of the band
    ScatterSite site = ScatterSite::PerObject;
    float tolerance = 0.01F;  ///< of the sums
  };

  /// Lists the surfaces where light is summed first; with `interpolates`, not those between knots.
  /// Surfaces whose light is summed at vertices get the vertices' light. `samples` are per pixel.
  void listKnots(gpu::CommandList& commands, const Inputs& inputs, std::uint32_t samples,
                 bool interpolates, const SeenSurfaces& seen) const;
  enum class Blocks : std::uint32_t { Narrow = 0, Wide = 1 };
  /// Interpolates after the sums at knots, first in wide blocks, then in narrow ones. Lists the
  /// surfaces in them that still need sums.
  void interpolate(gpu::CommandList& commands, const Inputs& inputs, Blocks blocks,
                   const SeenSurfaces& seen) const;

 private:
  gpu::Sampler nearest_;
  Variants<shaders::ScatterKnots> knots_;
  Variants<shaders::ScatterInterpolate> interpolate_;
};

}  // namespace opaline::passes
