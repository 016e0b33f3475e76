#pragma once

#include "renderer/frame/frame_context.h"

namespace opaline {

/// Records all that does not ask for light: rays, what clusters see and what acts on what.
void findShape(const FrameContext& frame);

/// Records how light falls on the scene and, in a plan that scatters, what it does there: the
/// exitance of vertices and clusters.
void findLight(const FrameContext& frame);

}  // namespace opaline
