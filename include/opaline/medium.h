#pragma once

#include <array>
#include <string>

namespace opaline {

/// A homogeneous, highly scattering medium behind a smooth dielectric boundary, per colour channel.
struct Medium {
  std::string name;
  std::array<double, 3> sigmaSPrimePerMm{};  ///< reduced scattering coefficient σ_s', mm⁻¹, ≥ 0
  std::array<double, 3> sigmaAPerMm{};       ///< absorption coefficient σ_a, mm⁻¹, ≥ 0
  double eta = 1.3;                          ///< relative index of refraction, in [1.01, 3]
};

}  // namespace opaline
