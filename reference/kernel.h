#pragma once

#include <array>

#include "bssrdf/profile.h"
#include "reference/vector.h"

namespace opaline::reference {

/// R_d of one channel and its derivatives: with s = r² and R_d = G₀(s), dG_k/ds = -G_{k+1}/2. All
/// are positive and fall with r.
class Kernel {
 public:
  explicit Kernel(const bssrdf::Profile& profile);

  /// G₀ … G₄ at a distance, given its square.
  std::array<double, 5> operator()(double squaredMm2) const;

  /// The factor by which the remainder of a third-order Taylor expansion, over a ball of that
  /// radius at that distance, may exceed its fourth-order term at the centre.
  double growth(double squaredMm2, double radiusMm) const;

  /// The depth of the source nearest to the surface, mm. The kernel does not vary on smaller
  /// scales.
  double depthMm() const { return poles_[0].depthMm; }

 private:
  /// Weights of g₀ = e^{-σd}/d and g₁ = -g₀'/d, where d is the distance from a source at that
  /// depth.
  struct Pole {
    double depthMm = 0;
    double fluence = 0;
    double flux = 0;
  };

  double sigmaTrPerMm_ = 0;
  std::array<Pole, 2> poles_{};
};

}  // namespace opaline::reference
