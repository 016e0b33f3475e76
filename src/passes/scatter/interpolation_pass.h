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

/// Which surfaces that pixels see need a sum of their own. In blocks of 8×8 or 4×4 pixels that one
/// smooth surface fills, light is interpolated between knots, where it changes evenly from each to
/// the next.
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

  /// Lists where light is summed first: with `interpolates` not between knots.
  /// Surfaces whose light is summed at vertices get what those have. `samples` are of a pixel.
  void listKnots(gpu::CommandList& commands, const Inputs& inputs, std::uint32_t samples,
                 bool interpolates, const SeenSurfaces& seen) const;
  enum class Blocks : std::uint32_t { Narrow = 0, Wide = 1 };
  /// After the sums there, first of wide blocks, then of narrow ones. Lists the surfaces in them
  /// that need sums all the same.
  void interpolate(gpu::CommandList& commands, const Inputs& inputs, Blocks blocks,
                   const SeenSurfaces& seen) const;

 private:
  gpu::Sampler nearest_;
  Variants<shaders::ScatterKnots> knots_;
  Variants<shaders::ScatterInterpolate> interpolate_;
};

}  // namespace opaline::passes
