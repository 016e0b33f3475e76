#pragma once

#include <optional>
#include <string_view>

#include "opaline/medium.h"
#include "scene/gltf/file.h"

namespace opaline::scene {

/// The medium of a primitive, from the first of these that there is: measured coefficients in the
/// material's extras (sigma_s_prime_per_mm, sigma_a_per_mm, eta); a material, mesh or node named
/// like a medium; KHR_materials_volume_scatter with KHR_materials_volume; marble, if it lets light
/// through in some other way. None if nothing says so. Throws Error for a material that does not
/// exist.
std::optional<Medium> gltfMedium(const Input& input, const tinygltf::Model& model, int material,
                                 std::string_view meshName, std::string_view nodeName);

/// Whether KHR_materials_volume_scatter and KHR_materials_volume say together what it is of.
bool saysMediumByVolume(const tinygltf::Material& material);

}  // namespace opaline::scene
