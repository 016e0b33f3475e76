#pragma once

#include "opaline/render_options.h"
#include "renderer/frame/camera_view.h"
#include "renderer/frame/frame_plan.h"
#include "renderer/frame/view_resources.h"
#include "renderer/scene/scene_changes.h"

namespace opaline {

/// Whether the view's next picture has to find what its pixels see, or may `reuse` what the last
/// one found. If it has to, that counts as found from now on.
bool mustFindSight(const RenderOptions& options, const FramePlan& plan, bool reuse,
                   const SceneChanges& changes, const CameraView& camera, ViewResources& view);

}  // namespace opaline
