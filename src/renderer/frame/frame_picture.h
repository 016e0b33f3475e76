#pragma once

#include "renderer/frame/frame_context.h"

namespace opaline {

/// Records what the pixels' centres see, and the variables that are wanted of it.
void lookAtCentres(const FrameContext& frame);

/// Records the surfaces that pixels see, scattering at fragments and shading, for one band of the
/// picture after the other. A plan without `sight` reuses the surfaces of an earlier frame.
void makePicture(const FrameContext& frame);

}  // namespace opaline
