#pragma once

#include <cstdint>
#include <vector>

#include "lights/spot.h"
#include "reference/geometry.h"
#include "reference/sky_table.h"
#include "reference/vector.h"

namespace opaline::reference {

/// Irradiance that enters the surface (physics of Gong et al. 2008, Eq. 7 and 9): directional,
/// point, spot and area lights with exact Fresnel transmittance and exact shadows; ambient light
/// and environment unshadowed, or where that is asked for shadowed as by many lights all around. Of
/// opaque bodies all that arrives, always shadowed.
class Irradiance {
 public:
  enum class Sky : std::uint8_t { Unshadowed, Shadowed };
  explicit Irradiance(const Geometry& geometry, Sky sky = Sky::Unshadowed);

  /// E at a point of the surface. May be called from several threads at once.
  Colour operator()(const SurfacePoint& point) const;

  /// The brightest that a surface can be: every light facing it at the distance of the point.
  /// For telling what is negligible.
  Colour facing(const SurfacePoint& point) const;

 private:
  struct Light {
    bool isPoint = false;
    Vector place{};  ///< unit direction to it, or position in mm
    Colour power{};  ///< irradiance, or intensity
    Vector axis{};   ///< where a spot light shines to
    SpotFalloff falloff{};
  };
  struct Ambient {
    double eta = 0;  ///< 0: all that arrives
    SkyTable sky;
  };

  /// What falls on a surface from an area light, by places all over it.
  Colour fromArea(const AreaLight& light, const SurfacePoint& point, const Vector& outside,
                  double eta) const;

  /// One of many directions that stand for the same solid angle.
  struct SkyRay {
    Vector direction{};
    Colour radiance{};
  };

  Colour skyAt(const SurfacePoint& point, const Vector& outside) const;

  const Geometry& geometry_;
  Sky sky_;
  std::vector<SkyRay> skyRays_;  ///< for where the sky is shadowed
  std::vector<Light> lights_;
  std::vector<AreaLight> areas_;
  std::vector<Ambient> ambients_;       ///< one for each index of refraction
  std::vector<std::size_t> ambientOf_;  ///< per body
};

}  // namespace opaline::reference
