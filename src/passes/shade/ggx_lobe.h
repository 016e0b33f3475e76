#pragma once

#include <cstdint>
#include <functional>

namespace opaline::passes {

/// What a GGX surface of roughness² = alpha, seen at that cosine to its normal, mirrors of light
/// from everywhere, where its facets reflect `reflectance` by the cosine to them. By sampling
/// visible normals (Heitz 2018), error below 0.002 for 1024 samples.
double mirroredOfAll(double alpha, double cosine, std::uint32_t samples,
                     const std::function<double(double)>& reflectance);

}  // namespace opaline::passes
