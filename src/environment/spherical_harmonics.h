#pragma once

#include <array>

#include "opaline/image.h"
#include "opaline/types.h"

namespace opaline {

/// Real, orthonormal spherical harmonics of bands 0–2 at a unit direction, ordered (0,0) (1,-1)
/// (1,0) (1,1) (2,-2) (2,-1) (2,0) (2,1) (2,2), z up in the usual formulas (Ramamoorthi and
/// Hanrahan 2001).
std::array<double, 9> sphericalHarmonics(const Vec3& direction);

/// RGB coefficients L_lm of a radiance field.
using ShCoefficients = std::array<std::array<double, 3>, 9>;

/// Integral of radiance times basis over the sphere, exact for latitude-longitude pixels of
/// constant radiance. An image without pixels is dark.
ShCoefficients projectEnvironment(const Image& latLong);

/// The same for a uniform radiance.
ShCoefficients projectUniform(const Rgb& radiance);

/// Evenly spread unit directions (spherical Fibonacci lattice, Swinbank and Purser 2006).
Vec3 latticeDirection(int index, int count);

/// The unit direction at a place of a latitude-longitude image, u from left to right and v from top
/// to bottom in [0,1], and back: see Lighting::environment for the convention.
Vec3 latLongDirection(double u, double v);
std::array<double, 2> latLongCoordinates(const Vec3& direction);

/// Zonal coefficients Â_l = 2π ∫₀¹ F_t(η,μ) μ P_l(μ) dμ, l = 0, 1, 2, of the irradiance kernel that
/// includes the Fresnel transmittance.
std::array<double, 3> irradianceKernel(double eta);

/// Damps bands 1 and 2 just so far that irradiance is negative in no direction of a fixed, dense
/// set (Sloan 2008, windowing); leaves smooth environments alone.
ShCoefficients windowed(const ShCoefficients& coefficients, const std::array<double, 3>& kernel);

/// E_amb(n) = Σ_l Â_l Σ_m L_lm Y_lm(n), clamped at 0.
std::array<double, 3> ambientIrradiance(const ShCoefficients& coefficients,
                                        const std::array<double, 3>& kernel, const Vec3& normal);

}  // namespace opaline
