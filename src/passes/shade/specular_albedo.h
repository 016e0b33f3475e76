#pragma once

#include <vector>

namespace opaline::passes {

/// Number of entries that specularAlbedo() returns; the shader has the same constant.
constexpr int specularAlbedoEntries = 64;

/// The share of light from everywhere that a GGX surface with exact Fresnel reflectance mirrors
/// into a direction, at the cosines (i + ½)/64. α = roughness². By sampling visible normals (Heitz
/// 2018); the error is below 0.002.
std::vector<float> specularAlbedo(double eta, double roughness);

}  // namespace opaline::passes
