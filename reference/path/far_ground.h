#pragma once

#include <cstddef>
#include <cstdint>

#include "reference/geometry.h"
#include "reference/path/random.h"

namespace opaline::reference {

/// The part of a ground beyond some radius around the bodies on it, in one channel. An endless
/// plane reflects much of its light from there, but hardly any particle would reach it. That light
/// comes only from the sky and from lights that are far away themselves.
class FarGround {
 public:
  /// All arguments must outlive it. The ground is perpendicular to y.
  FarGround(const Geometry& geometry, std::uint32_t ground, std::size_t channel, double nearMm);

  /// Whether a light is far enough away to count; others are ignored.
  bool counts(const Vector& positionMm, double reachMm = 0) const;

  /// Whether it blocks light that comes from infinitely far away in a direction.
  bool hides(const Vector& place, const Vector& direction) const;

  /// The distance along a ray to its upper side; infinite where the ray does not meet it.
  double distanceAlong(const Vector& origin, const Vector& direction) const;
  /// A sample of the radiance that it sends through a place above it in a direction, between 0 and
  /// mostRadiance().
  double radianceThrough(const Vector& place, const Vector& direction, Random& random) const;
  double mostRadiance() const { return givenBack_ * mostIrradiance_; }

 private:
  bool isFar(const Vector& place) const;
  double irradianceAt(const SurfacePoint& point, Random& random) const;

  const Geometry& geometry_;
  std::uint32_t ground_;
  std::size_t channel_;
  Vector centre_{};
  double heightMm_ = 0;
  double nearMm_;
  double givenBack_ = 0;  ///< radiance per irradiance
  double sky_ = 0;        ///< irradiance
  double mostIrradiance_ = 0;
};

}  // namespace opaline::reference
