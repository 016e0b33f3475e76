#pragma once

#include "environment/spherical_harmonics.h"
#include "opaline/scene.h"

namespace opaline {

/// The sky is all light that comes from everywhere: Lighting::ambient and Lighting::environment
/// together. Whether it is dark.
bool skyIsDark(const Lighting& lighting);

bool sameSky(const Lighting& a, const Lighting& b);

/// Its radiance in spherical harmonics.
ShCoefficients projectSky(const Lighting& lighting);

}  // namespace opaline
