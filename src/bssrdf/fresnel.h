#pragma once

namespace opaline::bssrdf {

/// Exact unpolarised reflectance of a smooth dielectric for light from outside. `eta` > 0 relative
/// index, `cosTheta` in [0,1] outside. Fresnel 1823.
double fresnelReflectance(double eta, double cosTheta);

/// The same for light from inside, 1 beyond the critical angle. `cosTheta` in [0,1] inside.
double fresnelReflectanceInside(double eta, double cosTheta);

/// Mean transmittance of diffuse light from outside, 2∫₀¹ F_t μ dμ, to 1e-10.
double meanTransmittance(double eta);

/// Mean cosine inside of diffuse light that entered from outside, eta ≥ 1: ∫₀¹ F_t μ μ_in dμ /
/// ∫₀¹ F_t μ dμ.
double meanCosineInside(double eta);

/// Of diffuse light that entered a slab, the share that each side has to mirror so that light of
/// the mean cosine inside collides as often as light of all directions does, each mirrored by
/// Fresnel's law; eta ≥ 1. It depends little on the slab's thickness. For 0.3 free paths it is
/// exact; from 0.1 to 10, what collides is within 0.7 %.
double mirroredOfEntered(double eta);

/// Classic internal diffuse reflectance F_dr (Egan and Hilgeman 1973, as in Jensen et al. 2001).
double diffuseReflectanceInside(double eta);

/// Moments of the reflectance from inside, eta ≥ 1: 2C₁ = 2∫₀¹ F μ dμ and 3C₂ = 3∫₀¹ F μ² dμ, by
/// the fits of d'Eon 2012 where these hold, else exactly.
double twoC1(double eta);
double threeC2(double eta);

}  // namespace opaline::bssrdf
