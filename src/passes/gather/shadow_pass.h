#pragma once

#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/gather/cutout_shadow.frag.h"
#include "shaders/gather/cutout_shadow.vert.h"
#include "shaders/gather/shadow.vert.h"
#include "shaders/gather/shadow_depths.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Draws the depth of the scene for shadow views of the frame. Williams 1978.
class ShadowPass {
 public:
  explicit ShadowPass(gpu::Device& device);

  /// Makes `views` maps of that size, at least one so that it can be bound. `cutOut`: some surfaces
  /// have holes.
  static ShadowMaps makeMaps(gpu::Device& device, std::uint32_t size, std::uint32_t views,
                             bool cutOut);

  /// `maps.depth` has at least as many layers as the frame has shadow views.
  void record(gpu::CommandList& commands, FrameView& frame, DeformedMesh& mesh,
              const CutOuts& cutOuts, const ShadowViews& views, ShadowMaps& maps) const;

 private:
  void draw(gpu::CommandList& commands, FrameView& frame, DeformedMesh& mesh,
            const CutOuts& cutOuts, const ShadowViews& views, ShadowMaps& maps) const;
  void recordByInvocations(gpu::CommandList& commands, FrameView& frame, DeformedMesh& mesh,
                           const ShadowViews& views, ShadowMaps& maps) const;
  void bindCutOut(gpu::CommandList& commands, FrameView& frame, DeformedMesh& mesh,
                  const CutOuts& cutOuts, std::uint32_t view) const;

  gpu::Graphics<shaders::GatherShadowVert> pipeline_;
  gpu::Graphics<shaders::GatherCutoutShadowVert, shaders::GatherCutoutShadowFrag> cutOut_;
  gpu::Compute<shaders::GatherShadowDepths> depths_;
};

}  // namespace opaline::passes
