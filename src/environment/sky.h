#pragma once

#include <vector>

#include "opaline/scene.h"

namespace opaline {

/// Whether the sky is dark. The sky is all light from the surroundings: Lighting::ambient and
/// Lighting::environment together.
bool skyIsDark(const Lighting& lighting);

bool sameSky(const Lighting& a, const Lighting& b);

/// The sky in parts, from which irradiance is computed.
struct SkyParts {
  static constexpr int width = 96;  ///< latitude-longitude, 3.75° each, top row first
  static constexpr int height = 48;
  static constexpr int count = width * height;

  struct Part {
    Vec3 direction{};      ///< unit, of its middle
    float solidAngle = 0;  ///< sr
    Rgb radiance{};        ///< mean over it, of the environment
  };
  Rgb ambient{};            ///< radiance in addition to the parts
  std::vector<Part> parts;  ///< none where there is no environment

  /// Mean radiance of the part that a direction lies in, with ambient light.
  Rgb radianceAt(const Vec3& direction) const;
};

/// Conserves light, whatever the environment's size. An environment without pixels is dark.
SkyParts partsOfSky(const Lighting& lighting);

}  // namespace opaline
