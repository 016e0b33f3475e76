#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "opaline/medium.h"
#include "scene/gltf/textures.h"
#include "scene/material.h"

namespace opaline::scene {

/// What KHR_materials_volume_scatter says of a material, or its successor KHR_materials_scatter
/// where that scatters in a volume. The colour is multiscatterColorFactor (multiscatterColor in
/// older files) times the strength of the scattering. scatterAnisotropy is the g of the phase
/// function.
struct GltfScattering {
  std::array<double, 3> color{1, 1, 1};
  double anisotropy = 0;
  std::optional<tinygltf::Value> texture{};          ///< as JSON; its colours multiply `color`
  std::optional<tinygltf::Value> strengthTexture{};  ///< its alpha multiplies `color`

  /// Whether the two textures lie differently on the surface. The mean of the strengths counts
  /// then.
  bool texturesLieApart() const;
};
std::optional<GltfScattering> gltfScattering(const tinygltf::Material& material);

/// The medium of a primitive, from the first of these that applies: measured coefficients in the
/// material's extras (sigma_s_prime_per_mm, sigma_a_per_mm, eta); an appearance in the extras
/// (mean_free_path_mm, color, g, eta), whose color may be the base colour; a material, mesh or node
/// named after a medium; gltfScattering() with KHR_materials_volume; marble, if the material lets
/// light through in some other way. A texture of colours becomes its paint. None if nothing
/// applies. Throws Error for a material that does not exist.
std::optional<Translucent> gltfMedium(const Input& input, const tinygltf::Model& model,
                                      int material, std::string_view meshName,
                                      std::string_view nodeName, GltfTextures& textures);

/// Whether the base colour gives the medium its look.
bool baseColorIsOfMedium(const tinygltf::Material& material);

/// Whether KHR_materials_volume and a scattering extension together describe a medium.
bool saysMediumByVolume(const tinygltf::Material& material);

/// Whether the extras describe a medium; they take precedence.
bool saysMediumInExtras(const tinygltf::Material& material);

/// The medium that the extensions describe, without textures. None where it cannot be rendered.
std::optional<Medium> gltfMediumByVolume(const Input& input, const tinygltf::Material& material);

}  // namespace opaline::scene
