#pragma once

#include <array>
#include <string>

namespace opaline {

/// A homogeneous, highly scattering medium behind a smooth dielectric boundary, per colour channel.
struct Medium {
  std::string name;
  std::array<double, 3> sigmaSPrimePerMm{};  ///< reduced scattering σ_s', mm⁻¹, in (0, 1e6]
  std::array<double, 3> sigmaAPerMm{};       ///< absorption σ_a, mm⁻¹, in [0, 1e6]
  double eta = 1.3;                          ///< relative index of refraction, in [1.01, 3]

  bool operator==(const Medium&) const = default;
};

/// Why the medium cannot be rendered, as a sentence; empty if it can.
std::string complaintAbout(const Medium& medium);

}  // namespace opaline
