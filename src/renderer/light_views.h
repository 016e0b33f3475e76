#pragma once

#include <cstdint>

#include "opaline/scene.h"
#include "shaders/shared/frame.h"

namespace opaline {

/// Number of shadow maps that the lights need: 1 for a directional light, 6 for a point light.
std::uint32_t shadowViewCount(const Lighting& lighting);

/// Fills the lights and shadow views of a frame. Directional lights get an orthographic view fitted
/// to the box, point lights the six faces of a cube, each wider than 90° by the texels that
/// filtering reaches beyond its edge. Depth is reversed. The lighting has been validated.
void fillLights(const Lighting& lighting, const Bounds& bounds, std::uint32_t shadowSize,
                shared::FrameData& frame);

}  // namespace opaline
