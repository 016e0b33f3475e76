#pragma once

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "passes/variants.h"
#include "shaders/boundary/entered_around.comp.h"
#include "shaders/boundary/reentry.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Finds how much of the light that has just left clusters enters others, by what their rays met.
class ReentryPass {
 public:
  explicit ReentryPass(gpu::Device& device);

  /// Records the light that enters, and its power below the surface. With `isFirst` it includes
  /// light that was mirrored on arrival.
  void record(gpu::CommandList& commands, SceneTables& tables, bool isFirst,
              Clusters& clusters) const;

 private:
  static Variants<shaders::BoundaryReentry> make(gpu::Device& device, bool withPaint);
  void recordAround(gpu::CommandList& commands, SceneTables& tables, Clusters& clusters) const;

  VariantsOfTwo<shaders::BoundaryReentry> reentry_;  ///< indexed by paint, then other bodies
  Variants<shaders::BoundaryEnteredAround> around_;  ///< indexed by paint
};

}  // namespace opaline::passes
