#pragma once

#include <array>

namespace opaline::bssrdf {

/// Directions in which diffuse light leaves a medium through its smooth surface: Gauss's rule of
/// two points over the cosine inside, for light that is equally bright in all directions below the
/// surface.
struct ExitDirections {
  std::array<double, 2> cosines{};   ///< inside
  std::array<double, 2> mirrored{};  ///< Fresnel's reflectance there
  std::array<double, 2> weights{};   ///< they sum to 1
};

/// `eta` ≥ 1. ∫₀¹ F_t μ f(μ_in) dμ / ∫₀¹ F_t μ dμ, over cosines μ outside, is Σ weight f(cosine):
/// exactly for polynomials f of up to the third degree.
ExitDirections exitDirections(double eta);

}  // namespace opaline::bssrdf
