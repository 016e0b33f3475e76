#pragma once

#include <array>

#include "opaline/scene.h"

namespace opaline {

/// A place of an area light, in double precision.
struct AreaPoint {
  std::array<double, 3> positionMm{};
  std::array<double, 3> normal{};  ///< unit, to the side that shines
};

Rgb radianceOf(const AreaLight& light);

/// Whether it shines to the side away from its normals as well.
bool isTwoSided(const AreaLight& light);

/// Of what shines, one side of it.
double areaMm2(const AreaLight& light);

/// The place for two numbers in [0, 1]: even numbers make even places.
AreaPoint pointOn(const AreaLight& light, double x, double y);

/// The middle of the light, and how far any of it is from there.
std::array<double, 3> middleOf(const AreaLight& light);
double reachMm(const AreaLight& light);

}  // namespace opaline
