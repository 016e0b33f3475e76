#pragma once

#include <vector>

namespace opaline::passes {

/// Number of entries that specularAlbedo returns; the shader knows the same.
constexpr int specularAlbedoEntries = 64;

/// Part of the light from everywhere that a GGX surface with exact Fresnel reflectance sends into a
/// direction, at the cosines (i + ½)/64. α = roughness². By sampling visible normals (Heitz 2018),
/// error below 0.002.
std::vector<float> specularAlbedo(double eta, double roughness);

}  // namespace opaline::passes
