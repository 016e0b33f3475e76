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

/// Whether the light also shines to the side that its normals do not face.
bool isTwoSided(const AreaLight& light);

/// Whether the picture itself shows the light.
bool isVisible(const AreaLight& light);

/// The distance from a place, along a unit direction, at which the light is first seen, mm; nothing
/// if it is not seen.
std::optional<double> distanceAlong(const std::array<double, 3>& fromMm,
                                    const std::array<double, 3>& direction, const AreaLight& light);

/// The area of one shining side.
double areaMm2(const AreaLight& light);

/// A place on the light for two numbers in [0, 1]. Uniformly distributed numbers give uniformly
/// distributed places.
AreaPoint pointOn(const AreaLight& light, double x, double y);

/// The unit normal to the side that shines, at a place of the light.
std::array<double, 3> normalAt(const AreaLight& light, const std::array<double, 3>& placeMm);

/// The middle of the light, and the largest distance of its points from there.
std::array<double, 3> middleOf(const AreaLight& light);
double reachMm(const AreaLight& light);

}  // namespace opaline
