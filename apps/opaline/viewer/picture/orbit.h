#pragma once

#include "opaline/scene.h"

namespace opaline::app::viewer {

/// Moves of a camera by hand. Each keeps it finite and aimed at its target.

/// Turns it about its target, to the right by `yaw` and up by `pitch`, in radians. It never passes
/// the pole.
void orbit(Camera& camera, float yaw, float pitch);

/// Moves camera and target parallel to the picture, in units of its height.
void pan(Camera& camera, float right, float up);

/// Multiplies the distance to the target, limited in proportion to the scene's diagonal.
void dolly(Camera& camera, float factor, float diagonalMm);

}  // namespace opaline::app::viewer
