#pragma once

#include <cstddef>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/gather/fit.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Fits shadow views and near plane to the box around this frame's surface.
class FitPass {
 public:
  explicit FitPass(gpu::Device& device);

  static FrameView makeView(gpu::Device& device);

  /// `upload` holds, from `offset` on, a shared::FrameData whose lights have place, power and
  /// views, and whose worldToClip has any near plane.
  void record(gpu::CommandList& commands, gpu::Buffer& upload, std::size_t offset,
              DeformedMesh& mesh, FrameView& frame) const;

 private:
  gpu::Compute<shaders::GatherFit> pipeline_;
};

}  // namespace opaline::passes
