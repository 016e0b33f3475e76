#pragma once

#include <array>

#include "bssrdf/profile.h"
#include "reference/vector.h"

namespace opaline::reference {

/// R_d of one channel and its derivatives. With s = r² and R_d = G₀(s), the functions below follow
/// from dG_k/ds = -G_{k+1}/2; each falls monotonically with r.
class Kernel {
 public:
  explicit Kernel(const bssrdf::Profile& profile);

  /// G₀ … G₃ at one distance, and what they are at most anywhere nearer, down to `leastMm`.
  struct Derivatives {
    std::array<double, 4> values{};
    double mostG2 = 0;
    double mostG3 = 0;
  };
  Derivatives operator()(double squaredMm2, double leastMm) const;

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
  bool hasFluence_ = false;
};

}  // namespace opaline::reference
