#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "opaline/medium.h"
#include "scene/gltf/textures.h"
#include "scene/material.h"

namespace opaline::scene {

/// What KHR_materials_volume_scatter says of a material, or its successor KHR_materials_scatter
/// where that scatters in a volume: multiscatterColorFactor, multiscatterColor in older files,
/// times the strength of the scattering is the colour, and scatterAnisotropy the g of the phase
/// function.
struct GltfScattering {
  std::array<double, 3> color{1, 1, 1};
  double anisotropy = 0;
  std::optional<tinygltf::Value> texture{};          ///< as JSON; its colours multiply the color
  std::optional<tinygltf::Value> strengthTexture{};  ///< its alpha does

  /// Both, on different places of the surface: then the mean of the strengths counts.
  bool texturesLieApart() const;
};
std::optional<GltfScattering> gltfScattering(const tinygltf::Material& material);

/// The medium of a primitive, from the first of these that there is: measured coefficients in the
/// material's extras (sigma_s_prime_per_mm, sigma_a_per_mm, eta); its appearance there
/// (mean_free_path_mm, color, g, eta), whose color may be the base colour; a material, mesh or node
/// named like a medium; gltfScattering() with KHR_materials_volume; marble, if it lets light
/// through in some other way. A texture of colours is its paint. None if nothing says so. Throws
/// Error for a material that does not exist.
std::optional<Translucent> gltfMedium(const Input& input, const tinygltf::Model& model,
                                      int material, std::string_view meshName,
                                      std::string_view nodeName, GltfTextures& textures);

/// Whether the base colour says what the medium looks like.
bool baseColorIsOfMedium(const tinygltf::Material& material);

/// Whether these two say together what it is of.
bool saysMediumByVolume(const tinygltf::Material& material);

/// Whether extras say it, which come first.
bool saysMediumInExtras(const tinygltf::Material& material);

/// What they say without textures. None where they say nothing that can be rendered.
std::optional<Medium> gltfMediumByVolume(const Input& input, const tinygltf::Material& material);

}  // namespace opaline::scene
