#pragma once

#include "opaline/scene.h"

namespace opaline::app::viewer {

/// How a camera is led by hand. Every call keeps it finite and looking at its target.

/// Turns it about its target: to the right by `yaw`, above by `pitch`, radians. It never goes over
/// the top.
void orbit(Camera& camera, float yaw, float pitch);

/// Moves camera and target along the picture, in heights of the picture.
void pan(Camera& camera, float right, float up);

/// Multiplies the distance to the target; it stays within these of the scene's diagonal.
void dolly(Camera& camera, float factor, float diagonalMm);

}  // namespace opaline::app::viewer
