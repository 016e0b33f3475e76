#pragma once

#include <array>
#include <optional>

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

/// Whether the picture itself shows it.
bool isVisible(const AreaLight& light);

/// How far along a unit direction from a place it is seen first, mm; nothing where it is not seen.
std::optional<double> distanceAlong(const std::array<double, 3>& fromMm,
                                    const std::array<double, 3>& direction, const AreaLight& light);

/// Of what shines, one side of it.
double areaMm2(const AreaLight& light);

/// The place for two numbers in [0, 1]: even numbers make even places.
AreaPoint pointOn(const AreaLight& light, double x, double y);

/// The unit normal to the side that shines, at a place of the light.
std::array<double, 3> normalAt(const AreaLight& light, const std::array<double, 3>& placeMm);

/// The middle of the light, and how far any of it is from there.
std::array<double, 3> middleOf(const AreaLight& light);
double reachMm(const AreaLight& light);

}  // namespace opaline
