#pragma once

#include "renderer/frame/frame_context.h"

namespace opaline {

/// Records all that does not depend on light: rays, what clusters see, and which clusters act on
/// which.
void findShape(const FrameContext& frame);

/// Records how light falls on the scene and, in a plan that scatters, the exitance of vertices and
/// clusters.
void findLight(const FrameContext& frame);

}  // namespace opaline
