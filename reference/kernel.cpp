#include "reference/kernel.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace opaline::reference {

// Jensen et al. 2001, Eq. 4, and d'Eon 2012: two sources below and above the surface.
Kernel::Kernel(const bssrdf::Profile& profile) : sigmaTrPerMm_(profile.sigmaTrPerMm) {
  const double scale = profile.albedo / (4 * std::numbers::pi);
  double flux = scale;
  double fluence = 0;
  if (profile.model == bssrdf::Model::BetterDipole) {
    flux = scale * profile.cE;
    fluence = scale * profile.cPhi / profile.diffusionMm;
  }
  poles_[0] = {profile.zRealMm, fluence, flux * profile.zRealMm};
  poles_[1] = {profile.zVirtualMm, -fluence, flux * profile.zVirtualMm};
}

// With x = σd, g₀ = e⁻ˣ/d and g_{k+1} = -g_k'/d:
// g₁ = e⁻ˣ (1 + x)/d³, g₂ = e⁻ˣ (3 + 3x + x²)/d⁵, g₃ = e⁻ˣ (15 + 15x + 6x² + x³)/d⁷,
// g₄ = e⁻ˣ (105 + 105x + 45x² + 10x³ + x⁴)/d⁹,
// g₅ = e⁻ˣ (945 + 945x + 420x² + 105x³ + 15x⁴ + x⁵)/d¹¹.
std::array<double, 5> Kernel::operator()(double squaredMm2) const {
  std::array<double, 5> result{};
  for (const Pole& pole : poles_) {
    const double d2 = squaredMm2 + pole.depthMm * pole.depthMm;
    const double d = std::sqrt(d2);
    const double x = sigmaTrPerMm_ * d;
    const double inverse2 = 1 / d2;
    std::array<double, 6> g{1,
                            1 + x,
                            3 + x * (3 + x),
                            15 + x * (15 + x * (6 + x)),
                            105 + x * (105 + x * (45 + x * (10 + x))),
                            945 + x * (945 + x * (420 + x * (105 + x * (15 + x))))};
    double power = std::exp(-x) / d;
    for (double& value : g) {
      value *= power;
      power *= inverse2;
    }
    for (std::size_t k = 0; k < 5; ++k) result[k] += pole.fluence * g[k] + pole.flux * g[k + 1];
  }
  return result;
}

// The fourth derivative is at most of the form e^{-σd} d⁻⁷, where d is the distance to the nearer
// source. Moving changes d by no more than the distance moved. So the remainder exceeds the term at
// the centre by less than ∫₀¹ 4 (1-t)³ (1-tx)⁻⁷ e^{tσρ} dt ≤ (1-x)⁻³ e^{σρ}, x = ρ/d; ∫₀¹ 4 (1-t)³
// (1-tx)⁻⁵ dt is 1/(1-x).
double Kernel::growth(double squaredMm2, double radiusMm) const {
  const double depth = poles_[0].depthMm;
  const double share = 1 - radiusMm / std::sqrt(squaredMm2 + depth * depth);
  if (share <= 0) return std::numeric_limits<double>::infinity();
  return std::exp(sigmaTrPerMm_ * radiusMm) / (share * share * share);
}

}  // namespace opaline::reference
