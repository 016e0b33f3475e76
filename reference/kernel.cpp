#include "reference/kernel.h"

#include <cmath>
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
  hasFluence_ = fluence != 0;
}

// With x = σd, g₀ = e⁻ˣ/d and g_{k+1} = -g_k'/d:
// g₁ = e⁻ˣ (1 + x)/d³, g₂ = e⁻ˣ (3 + 3x + x²)/d⁵, g₃ = e⁻ˣ (15 + 15x + 6x² + x³)/d⁷,
// g₄ = e⁻ˣ (105 + 105x + 45x² + 10x³ + x⁴)/d⁹.
Kernel::Derivatives Kernel::operator()(double squaredMm2, double leastMm) const {
  Derivatives result;
  double most2 = 0;
  double most3 = 0;
  double growth = 1;
  for (const Pole& pole : poles_) {
    const double d2 = squaredMm2 + pole.depthMm * pole.depthMm;
    const double d = std::sqrt(d2);
    const double inverse2 = 1 / d2;
    const double x = sigmaTrPerMm_ * d;
    const double decay = std::exp(-x);
    double power = decay / d;
    std::array<double, 5> g{};
    g[0] = power;
    g[1] = (1 + x) * (power *= inverse2);
    g[2] = (3 + x * (3 + x)) * (power *= inverse2);
    g[3] = (15 + x * (15 + x * (6 + x))) * (power *= inverse2);
    g[4] = (105 + x * (105 + x * (45 + x * (10 + x)))) * (power *= inverse2);
    for (std::size_t k = 0; k < 4; ++k) {
      result.values[k] += pole.fluence * g[k] + pole.flux * g[k + 1];
    }
    const double fluence = std::max(pole.fluence, 0.0);
    most2 += fluence * g[2] + pole.flux * g[3];
    most3 += fluence * g[3] + pole.flux * g[4];
    if (&pole == poles_.data()) {
      // g_k(d')/g_k(d) ≤ (d/d')^{2k+1} e^{σ(d-d')} for d' < d, and most for the nearest source.
      const double least = std::sqrt(leastMm * leastMm + pole.depthMm * pole.depthMm);
      const double ratio = d / least;
      const double ratio2 = ratio * ratio;
      const double ratio4 = ratio2 * ratio2;
      growth = ratio4 * ratio4 * ratio * std::exp(sigmaTrPerMm_ * (d - least));
    }
  }
  result.mostG2 = most2 * growth;
  result.mostG3 = most3 * growth;
  return result;
}

}  // namespace opaline::reference
