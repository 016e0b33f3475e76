#pragma once

#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/shared/frame.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Draws the depth of the scene for every shadow view of the frame. Williams 1978.
class ShadowPass {
 public:
  explicit ShadowPass(gpu::Device& device);

  /// `views` maps of that size; one even without lights, so that there is something to bind.
  static ShadowMaps makeMaps(gpu::Device& device, std::uint32_t size, std::uint32_t views);

  /// `views` matrices of `frame.shadowViews`; `maps.depth` has at least as many layers.
  void record(gpu::CommandList& commands, const shared::FrameData& frame, std::uint32_t views,
              DeformedMesh& mesh, ShadowMaps& maps) const;

 private:
  gpu::Pipeline pipeline_;
};

}  // namespace opaline::passes
