#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "lights/spot.h"
#include "reference/geometry.h"
#include "reference/path/random.h"
#include "reference/path/sky_pixels.h"

namespace opaline::reference {

/// Light that would arrive at a point from one place of a light, were nothing between.
struct LightSample {
  Vector direction{};  ///< unit, towards the light
  double distanceMm = std::numeric_limits<double>::infinity();
  Colour irradiance{};  ///< of a surface that faces it: radiance over density, where there is one
  double density = 0;   ///< of such samples, per steradian; 0 for light from a single direction
  bool isSky = false;
};

/// Light that comes along a ray which a surface sends.
struct LightAlong {
  Colour radiance{};
  double density = 0;  ///< of the samples that might have found it
  bool isSky = false;
};

/// The lights of a scene as paths from the eye find them: each by a sample of its own, and area
/// lights and the sky by rays that meet them as well.
class LightSamples {
 public:
  /// The scene must live as long.
  explicit LightSamples(const Scene& scene);

  /// Calls `take` with a sample of each light but constant ambient light.
  void forEach(const Vector& positionMm, Random& random,
               const std::function<void(const LightSample&)>& take) const;

  /// Calls `take` with each area light that a ray meets before that distance, and with the sky
  /// where it is infinite.
  void forEachAlong(const Vector& originMm, const Vector& direction, double distanceMm,
                    const std::function<void(const LightAlong&)>& take) const;

 private:
  std::optional<LightSample> ofArea(const AreaLight& light, const Vector& positionMm,
                                    Random& random) const;

  const Lighting& lighting_;
  std::optional<SkyPixels> environment_;
};

}  // namespace opaline::reference
