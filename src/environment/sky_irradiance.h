#pragma once

#include <array>
#include <functional>
#include <vector>

#include "environment/sky.h"

namespace opaline {

/// Irradiance by an unoccluded sky as a function of the surface's normal: the integral of radiance
/// over the hemisphere, weighted by a function of the cosine to the normal. It is exact for an even
/// sky and otherwise correct within some tenths of a per cent.
class SkyIrradiance {
 public:
  /// All light that arrives.
  static SkyIrradiance arriving(SkyParts sky);
  /// The light that enters a medium of that index of refraction, E = ∫ L F_t(η,μ) μ dω.
  static SkyIrradiance entering(SkyParts sky, double eta);

  std::array<double, 3> at(const Vec3& normal) const;

 private:
  SkyIrradiance(SkyParts sky, const std::function<double(double)>& weight, double whole);

  float weightOf(float cosine) const;

  SkyParts sky_;
  std::vector<float> weights_;  ///< at evenly spaced cosines from 0 to 1
  double whole_;                ///< integral of the weight over the hemisphere
};

}  // namespace opaline
