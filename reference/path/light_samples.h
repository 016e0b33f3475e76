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

/// Light that would arrive at a point from one place of a light, if nothing were in the way.
struct LightSample {
  Vector direction{};  ///< unit, towards the light
  double distanceMm = std::numeric_limits<double>::infinity();
  Colour irradiance{};  ///< of a facing surface; divided by the density where there is one
  double density = 0;   ///< per steradian; 0 for light from a single direction
  bool isSky = false;
};

/// Light that arrives along a ray sent from a surface.
struct LightAlong {
  Colour radiance{};
  double density = 0;  ///< of the samples that might have found it
  bool isSky = false;
};

/// The lights of a scene for paths from the eye. Each light is sampled; area lights and the sky are
/// also found by rays that hit them.
class LightSamples {
 public:
  /// The scene must outlive it.
  explicit LightSamples(const Scene& scene);

  /// Calls `take` with a sample of each light, except constant ambient light.
  void forEach(const Vector& positionMm, Random& random,
               const std::function<void(const LightSample&)>& take) const;

  /// Calls `take` with each area light that a ray hits within that distance, and with the sky if
  /// the distance is infinite.
  void forEachAlong(const Vector& originMm, const Vector& direction, double distanceMm,
                    const std::function<void(const LightAlong&)>& take) const;

 private:
  std::optional<LightSample> ofArea(const AreaLight& light, const Vector& positionMm,
                                    Random& random) const;

  const Lighting& lighting_;
  std::optional<SkyPixels> environment_;
};

}  // namespace opaline::reference
