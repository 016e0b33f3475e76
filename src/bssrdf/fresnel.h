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

/// Of diffuse light that entered through a plane, the share that a parallel plane mirrors, eta ≥ 1:
/// ∫₀¹ F_t (1 − F_t) μ dμ / ∫₀¹ F_t μ dμ.
double meanReflectanceOfEntered(double eta);

/// Classic internal diffuse reflectance F_dr (Egan and Hilgeman 1973, as in Jensen et al. 2001).
double diffuseReflectanceInside(double eta);

/// Moments of the reflectance from inside, eta ≥ 1: 2C₁ = 2∫₀¹ F μ dμ and 3C₂ = 3∫₀¹ F μ² dμ, by
/// the fits of d'Eon 2012 where these hold, else exactly.
double twoC1(double eta);
double threeC2(double eta);

}  // namespace opaline::bssrdf
