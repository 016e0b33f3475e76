#pragma once

#include <vector>

#include "opaline/scene.h"

namespace opaline {

/// The sky is all light that comes from everywhere: Lighting::ambient and Lighting::environment
/// together. Whether it is dark.
bool skyIsDark(const Lighting& lighting);

bool sameSky(const Lighting& a, const Lighting& b);

/// The sky by parts, as irradiance is taken from it.
struct SkyParts {
  static constexpr int width = 96;  ///< 3.75° each, latitude-longitude, top row first
  static constexpr int height = 48;
  static constexpr int count = width * height;

  struct Part {
    Vec3 direction{};      ///< unit, of its middle
    float solidAngle = 0;  ///< sr
    Rgb radiance{};        ///< mean over it, of the environment
  };
  Rgb ambient{};            ///< radiance on top of it
  std::vector<Part> parts;  ///< none where there is no environment

  /// Mean radiance of the part that a direction lies in, with ambient light.
  Rgb radianceAt(const Vec3& direction) const;
};

/// Conserves light, whatever the environment's size. One without pixels is dark.
SkyParts partsOfSky(const Lighting& lighting);

}  // namespace opaline
