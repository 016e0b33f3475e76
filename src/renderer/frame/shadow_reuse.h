#pragma once

#include "renderer/frame/frame_plan.h"
#include "renderer/frame/view_resources.h"
#include "renderer/scene/scene_changes.h"
#include "shaders/shared/frame.h"

namespace opaline {

/// The shadow maps that the view's next frame has to draw: all, or with `reuse` those of lights
/// that have moved since the view's maps were drawn. They count as drawn from now on.
passes::ShadowViews shadowsToDraw(const FramePlan& plan, bool reuse, const SceneChanges& changes,
                                  const shared::FrameData& frame, ViewResources& view);

}  // namespace opaline
