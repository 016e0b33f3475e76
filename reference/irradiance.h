#pragma once

#include <cstdint>
#include <vector>

#include "lights/spot.h"
#include "reference/geometry.h"
#include "reference/sky_table.h"
#include "reference/vector.h"

namespace opaline::reference {

/// Irradiance that enters the surface (physics of Gong et al. 2008, Eq. 7 and 9). Directional,
/// point, spot and area lights have exact Fresnel transmittance and exact shadows. Ambient light
/// and environment are unshadowed, or on request shadowed as by many lights all around. For opaque
/// bodies it is all light that arrives, always shadowed.
class Irradiance {
 public:
  enum class Sky : std::uint8_t { Unshadowed, Shadowed };
  explicit Irradiance(const Geometry& geometry, Sky sky = Sky::Unshadowed);

  /// E at a point of the surface. Thread-safe.
  Colour operator()(const SurfacePoint& point) const;

  /// The largest irradiance that is possible: every light facing the surface at the point's
  /// distance. It serves to tell what is negligible.
  Colour facing(const SurfacePoint& point) const;

 private:
  struct Light {
    bool isPoint = false;
    Vector place{};  ///< unit direction to it, or position in mm
    Colour power{};  ///< irradiance, or intensity
    Vector axis{};   ///< the direction of a spot light
    SpotFalloff falloff{};
  };
  struct Ambient {
    double eta = 0;  ///< 0: all light that arrives counts
    SkyTable sky;
  };

  /// Irradiance from an area light, by places all over it.
  Colour fromArea(const AreaLight& light, const SurfacePoint& point, const Vector& outside,
                  double eta) const;

  /// One of many directions, each standing for the same solid angle.
  struct SkyRay {
    Vector direction{};
    Colour radiance{};
  };

  Colour skyAt(const SurfacePoint& point, const Vector& outside) const;

  const Geometry& geometry_;
  Sky sky_;
  std::vector<SkyRay> skyRays_;  ///< where the sky is shadowed
  std::vector<Light> lights_;
  std::vector<AreaLight> areas_;
  std::vector<Ambient> ambients_;       ///< one for each index of refraction
  std::vector<std::size_t> ambientOf_;  ///< per body
};

}  // namespace opaline::reference
