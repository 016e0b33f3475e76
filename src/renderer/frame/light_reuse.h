#pragma once

#include "renderer/frame/frame_plan.h"
#include "renderer/frame/view_resources.h"
#include "renderer/scene/scene_changes.h"

namespace opaline {

/// Knows whose light the surfels of a scene on the device still hold.
class LightReuse {
 public:
  /// Whether the view's next frame has to find its light, or may `reuse` the light that the view
  /// holds. If it has to and scatters, the view counts as lit for this frame from now on.
  bool mustFind(const RenderOptions& options, const FramePlan& plan, bool reuse,
                const SceneChanges& changes, ViewResources& view);

 private:
  // The view whose light the shared surfels and clusters hold. The pointer is only compared,
  // because the view may be gone; a new view at its address is not lit.
  const ViewResources* litSurfels_ = nullptr;
};

}  // namespace opaline
