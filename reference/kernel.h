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

  /// G₀ … G₄ at the distance whose square is given.
  std::array<double, 5> operator()(double squaredMm2) const;

  /// By how much the remainder of a Taylor expansion to third order, over a ball of that radius at
  /// that distance, may exceed its term of fourth order at the centre.
  double growth(double squaredMm2, double radiusMm) const;

  /// The depth of the source nearest to the surface, mm: nothing changes over less.
  double depthMm() const { return poles_[0].depthMm; }

 private:
  /// Weights of g₀ = e^{-σd}/d and of g₁ = -g₀'/d, at distance d from a source at that depth.
  struct Pole {
    double depthMm = 0;
    double fluence = 0;
    double flux = 0;
  };

  double sigmaTrPerMm_ = 0;
  std::array<Pole, 2> poles_{};
};

}  // namespace opaline::reference
