#pragma once

#include <cstdint>
#include <functional>

namespace opaline::passes {

/// The share of light from everywhere that a GGX surface of roughness² = alpha mirrors, seen at
/// that cosine to its normal. Its facets have the `reflectance` of the cosine to them. By sampling
/// visible normals (Heitz 2018); the error is below 0.002 for 1024 samples.
double mirroredOfAll(double alpha, double cosine, std::uint32_t samples,
                     const std::function<double(double)>& reflectance);

}  // namespace opaline::passes
