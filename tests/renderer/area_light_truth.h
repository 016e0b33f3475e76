#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "bssrdf/fresnel.h"
#include "lights/area.h"
#include "renderer/shapes.h"

namespace opaline::test {

// ∫ L F_t μ over the light, summed over places all over it without occluders. The plate lies at y =
// 0.
inline double byQuadrature(const AreaLight& light, const Vector& position, double eta,
                           const Vector& normal = {0, 1, 0}, int steps = 96) {
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < steps; ++k) {
      const AreaPoint place = pointOn(light, (i + 0.5) / steps, (k + 0.5) / steps);
      const Vector offset = Vector(place.positionMm) - position;
      const double squared = dot(offset, offset);
      const Vector direction = (1 / std::sqrt(squared)) * offset;
      const double cosine = std::min(dot(direction, normal), 1.0);
      const double facing = isTwoSided(light) ? std::abs(dot(direction, Vector(place.normal)))
                                              : -dot(direction, Vector(place.normal));
      if (cosine <= 0 || facing <= 0) continue;
      sum += facing * cosine * (1 - bssrdf::fresnelReflectance(eta, cosine)) / squared;
    }
  return static_cast<double>(radianceOf(light)[0]) * sum * areaMm2(light) / (steps * steps);
}

// The visible share of a disc beyond an edge at that distance from its middle: the area of a
// segment.
inline double shareBeyondEdge(double distance, double radius) {
  const double d = std::clamp(distance / radius, -1.0, 1.0);
  return (std::acos(d) - d * std::sqrt(1 - d * d)) / std::numbers::pi;
}

inline double percentile95(std::vector<double> errors) {
  std::sort(errors.begin(), errors.end());
  return errors[errors.size() * 95 / 100];
}

inline std::vector<AreaLight> everyShape() {
  return {
      RectangleLight{{4, 12, -3}, {6, 0, 1}, {1, 2, 5}, {3, 3, 3}, true},
      RectangleLight{{25, 3, 0}, {0, 8, 0}, {0, 0, 8}, {3, 3, 3}, true},  // crosses the horizon
      DiscLight{{-5, 9, 2}, {0.4F, -0.9F, 0.1F}, 5, {3, 3, 3}},
      SphereLight{{3, 11, 5}, 6, {3, 3, 3}},
      SphereLight{{-24, 2, 0}, 3, {3, 3, 3}},  // crosses the horizon
      TubeLight{{-15, 8, -4}, {12, 10, 6}, 1.5F, {3, 3, 3}},
  };
}

}  // namespace opaline::test
