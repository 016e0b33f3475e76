#pragma once

#include <array>

#include "opaline/image.h"
#include "opaline/types.h"

namespace opaline {

/// The unit direction at a place of a latitude-longitude image, u from left to right and v from top
/// to bottom in [0,1], and back: see Lighting::environment for the convention.
Vec3 latLongDirection(double u, double v);
std::array<double, 2> latLongCoordinates(const Vec3& direction);

/// Radiance that an environment sends from a direction, interpolated linearly between pixels.
Rgb radianceFrom(const Image& environment, const Vec3& direction);

/// Evenly spread unit directions (spherical Fibonacci lattice, Swinbank and Purser 2006).
Vec3 latticeDirection(int index, int count);

}  // namespace opaline
