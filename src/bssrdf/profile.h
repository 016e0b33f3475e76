#pragma once

#include <array>

#include "opaline/medium.h"
#include "opaline/render_options.h"

namespace opaline::bssrdf {

/// Coefficients of one channel and what follows from them.
struct Coefficients {
  double sigmaSPrimePerMm = 0;
  double sigmaAPerMm = 0;
  double sigmaTPrimePerMm = 0;
  double albedo = 0;          ///< α' = σ_s' / σ_t'
  double meanFreePathMm = 0;  ///< ℓ = 1 / σ_t'
  double eta = 1;
};

/// Channel 0, 1 or 2 of a medium. Requires σ_t' > 0.
Coefficients coefficients(const Medium& medium, int channel);

/// One channel of a medium by the delta-Eddington approximation (Joseph, Wiscombe and Weinman
/// 1976): the forward peak of its scattering, the part g², counts as light that goes straight on.
/// Media with g ≤ 0 have no such peak and stay as they are.
struct ScaledScattering {
  double sigmaTPerMm = 0;  ///< σ_t* = σ_s'(1 + g) + σ_a
  double albedo = 0;       ///< σ_s* / σ_t*
  double g = 0;            ///< g* = g / (1 + g), so that σ_s*(1 - g*) = σ_s'
};
ScaledScattering scaledScattering(const Medium& medium, int channel);

/// Whether two media are the same apart from their names.
bool isSameInside(const Medium& a, const Medium& b);

/// The shortest of the three channels.
double shortestMeanFreePathMm(const Medium& medium);

enum class Model { Dipole, BetterDipole };

/// The half-space model of a transport. Boundary transport takes its fine detail from the better
/// dipole, and open meshes get the better dipole alone.
Model modelOf(Transport transport);

/// Radially symmetric diffuse reflectance R_d(r) of a half-space, one channel:
/// Dipole       Jensen et al. 2001, Eq. 4
/// BetterDipole d'Eon 2012
struct Profile {
  Model model = Model::Dipole;
  double albedo = 0;        ///< α'
  double sigmaTrPerMm = 0;  ///< σ_tr, may be 0
  double zRealMm = 0;       ///< z_r
  double zVirtualMm = 0;    ///< z_v
  double diffusionMm = 0;   ///< D, mm (BetterDipole)
  double cPhi = 0;          ///< weight of fluence (BetterDipole)
  double cE = 0;            ///< weight of flux (BetterDipole)

  /// R_d(r), mm⁻². r ≥ 0 in mm.
  double operator()(double radiusMm) const;
  /// Integral over a disc of that radius, in [0,1]; infinity is allowed.
  double disc(double radiusMm) const;
  /// disc(∞).
  double totalReflectance() const;
};

Profile makeProfile(Model model, const Coefficients& coefficients);

/// Profiles of the three channels of a medium.
std::array<Profile, 3> makeProfiles(Model model, const Medium& medium);

/// Radiance per exitance, without the Fresnel factor towards the viewer. It is 1/π for the classic
/// dipole (Gong et al. 2008, Eq. 5) and the energy-conserving 1/(π F̄_t) of d'Eon 2012 for the
/// better dipole.
double exitFactor(Model model, double eta);

}  // namespace opaline::bssrdf
