#pragma once

#include "renderer/frame/frame_plan.h"
#include "renderer/frame/view_resources.h"
#include "renderer/scene/scene_changes.h"

namespace opaline {

/// Knows whose light the surfels of a scene on the device still hold.
class LightReuse {
 public:
  /// Whether the view's next frame has to find its light, or may `reuse` that which the view holds.
  /// If it has to, and scatters it, the view counts as lit by it from now on.
  bool mustFind(const RenderOptions& options, const FramePlan& plan, bool reuse,
                const SceneChanges& changes, ViewResources& view);

 private:
  // Whose light the surfels hold, and what boundary transport made of them: views share them.
  // Never followed: the view may be gone. Another in its place is not lit.
  const ViewResources* litSurfels_ = nullptr;
};

}  // namespace opaline
