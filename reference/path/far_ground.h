#pragma once

#include <cstddef>
#include <cstdint>

#include "reference/geometry.h"
#include "reference/path/random.h"

namespace opaline::reference {

/// A ground farther from the middle of what stands on it than some radius, in one channel. A plane
/// without an end gives much of its light from there, where hardly a particle comes from. But all
/// that is given back there is the light of the sky and of lights that are far away themselves.
class FarGround {
 public:
  /// All must live as long. The ground lies across y.
  FarGround(const Geometry& geometry, std::uint32_t ground, std::size_t channel, double nearMm);

  /// Whether a light there is so far away that it counts. Others do not.
  bool counts(const Vector& positionMm, double reachMm = 0) const;

  /// Whether it hides from a place what is infinitely far away and shines in a direction.
  bool hides(const Vector& place, const Vector& direction) const;

  /// How far along a ray it is met from above; infinite where it is not.
  double distanceAlong(const Vector& origin, const Vector& direction) const;
  /// Radiance that it sends through a place above it in a direction; a sample of that, between 0
  /// and mostRadiance().
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
