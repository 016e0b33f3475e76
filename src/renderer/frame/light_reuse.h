#pragma once

#include "renderer/frame/frame_plan.h"
#include "renderer/frame/prepared_frames.h"
#include "renderer/scene/scene_changes.h"

namespace opaline {

/// Knows whose light the device still holds.
class LightReuse {
 public:
  /// Whether the next frame has to find its light, or may take that which `frame` holds. If it has
  /// to, and scatters it, `frame` counts as lit by it from now on.
  bool mustFind(const RenderOptions& options, const FramePlan& plan, const SceneChanges& changes,
                PreparedFrame& frame);

 private:
  // Whose light the surfels hold, and what boundary transport made of them: all frames share them.
  // Never followed: it may be of resources that are made anew, which are not lit.
  const PreparedFrame* litSurfels_ = nullptr;
};

}  // namespace opaline
