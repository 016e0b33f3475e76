#pragma once

#include <cstdint>

#include "opaline/scene.h"
#include "shaders/shared/frame.h"

namespace opaline {

/// The number of all lights. Area lights come last.
std::uint32_t lightCount(const Lighting& lighting);

/// Number of shadow maps that the lights need: 1 for a directional light, 6 for a point light, 1 or
/// 6 for a spot light.
std::uint32_t shadowViewCount(const Lighting& lighting);

/// Fills in the frame's lights and which shadow views are theirs; passes::FitPass does the rest.
/// The lighting has been validated.
void fillLights(const Lighting& lighting, std::uint32_t shadowSize, shared::FrameData& frame);

}  // namespace opaline
