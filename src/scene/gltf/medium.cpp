#include "scene/gltf/medium.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bssrdf/profile.h"
#include "opaline/media.h"
#include "scene/gltf/json.h"
#include "scene/material.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

using Numbers3 = std::array<double, 3>;

double etaOf(const tinygltf::Material& material) {
  if (const auto eta = gltfNumber(material.extras, "eta")) return *eta;
  // Below 1.01 the dipole has no boundary; 1.5 is the extension's own default.
  const double ior = gltfNumber(gltfExtension(material, "KHR_materials_ior"), "ior").value_or(1.5);
  return std::clamp(ior, 1.01, 3.0);
}

std::optional<Medium> fromExtras(const tinygltf::Material& material) {
  const auto scattering = gltfNumbers<3>(material.extras, "sigma_s_prime_per_mm");
  const auto absorption = gltfNumbers<3>(material.extras, "sigma_a_per_mm");
  if (!scattering || !absorption) return std::nullopt;
  return Medium{cleanText(material.name), *scattering, *absorption, etaOf(material)};
}

/// The albedo α' whose dipole reflects `reflectance` of diffuse light in all, by bisection of
/// Jensen et al. 2001, Eq. 4 integrated over the plane, which grows with α'.
double albedoOf(double reflectance, double eta) {
  double low = 0;
  double high = 1;
  for (int step = 0; step < 60; ++step) {
    const double albedo = 0.5 * (low + high);
    Medium medium{"", {albedo, albedo, albedo}, {1 - albedo, 1 - albedo, 1 - albedo}, eta};
    const bssrdf::Profile profile =
        bssrdf::makeProfile(bssrdf::Model::Dipole, bssrdf::coefficients(medium, 0));
    (profile.totalReflectance() < reflectance ? low : high) = albedo;
  }
  return reflectance >= 1 ? 1.0 : 0.5 * (low + high);
}

/// KHR_materials_volume: light falls to attenuationColor after attenuationDistance metres, which is
/// exp(-σ_t d).
struct Volume {
  double attenuationDistance;
  Numbers3 attenuationColor;
  GltfScattering scattering;
};

std::optional<Volume> volumeOf(const tinygltf::Material& material) {
  const tinygltf::Value& volume = gltfExtension(material, "KHR_materials_volume");
  const auto distance = gltfNumber(volume, "attenuationDistance");
  const auto attenuation = gltfNumbers<3>(volume, "attenuationColor");
  const std::optional<GltfScattering> scattering = gltfScattering(material);
  if (!distance || !attenuation || !scattering || !(*distance > 0)) return std::nullopt;
  return Volume{*distance, *attenuation, *scattering};
}

/// A texture of its colours.
struct Colors {
  Texture texture;
  Rgb bright;
};

std::optional<Colors> colorsOf(const tinygltf::Material& material, GltfTextures& textures) {
  const std::optional<GltfScattering> scattering = gltfScattering(material);
  if (!scattering || !scattering->texture) return std::nullopt;
  std::optional<Texture> texture = textures.texture(*scattering->texture);
  if (!texture) return std::nullopt;
  const Rgb bright = brightColor(*texture->pixels);
  return Colors{std::move(*texture), bright};
}

/// On a medium that is bare where the texture has its brightest colours.
std::optional<Paint> paintOn(const Medium& medium, const std::optional<Colors>& colors) {
  if (!colors) return std::nullopt;
  Paint paint{.name = medium.name, .colorTexture = colors->texture};
  const Rgb bare = colorOf(medium);
  for (std::size_t c = 0; c < 3; ++c) {
    const float bright = colors->bright[c];
    paint.color[c] = bright > 0 ? std::min(bare[c] / bright, Paint::mostColor) : 1.0F;
  }
  return paint;
}

std::optional<Medium> fromVolume(const tinygltf::Material& material,
                                 const std::optional<Colors>& colors) {
  const std::optional<Volume> volume = volumeOf(material);
  if (!volume) return std::nullopt;
  Medium medium;
  medium.name = cleanText(material.name);
  medium.eta = etaOf(material);
  medium.g = volume->scattering.anisotropy;
  const Rgb bright = colors ? colors->bright : Rgb{1, 1, 1};
  for (std::size_t c = 0; c < 3; ++c) {
    const double reflectance =
        std::clamp(volume->scattering.color[c] * double{bright[c]}, 0.0, 1.0);
    const double left = std::clamp(volume->attenuationColor[c], 1e-6, 0.9999);
    const double extinctionPerMm = -std::log(left) / (1000 * volume->attenuationDistance);
    const double albedo = albedoOf(reflectance, medium.eta);
    // σ_t = σ_s' / (1 - g) + σ_a, with σ_s' = α' σ_t'.
    const double reducedPerMm =
        extinctionPerMm / (albedo / (1 - volume->scattering.anisotropy) + 1 - albedo);
    medium.sigmaSPrimePerMm[c] = albedo * reducedPerMm;
    medium.sigmaAPerMm[c] = (1 - albedo) * reducedPerMm;
  }
  return medium;
}

}  // namespace

std::optional<GltfScattering> gltfScattering(const tinygltf::Material& material) {
  const tinygltf::Value* scatter = &gltfExtension(material, "KHR_materials_volume_scatter");
  const tinygltf::Value& later = gltfExtension(material, "KHR_materials_scatter");
  const bool letsIn = material.extensions.contains("KHR_materials_transmission");
  if (letsIn && gltfNumber(later, "scatterStrengthFactor").value_or(0) > 0) scatter = &later;
  std::optional<Numbers3> color = gltfNumbers<3>(*scatter, "multiscatterColorFactor");
  if (!color) color = gltfNumbers<3>(*scatter, "multiscatterColor");
  const bool textured = scatter->Has("multiscatterColorTexture");
  if (!color && !textured && scatter != &later) return std::nullopt;
  GltfScattering found{.color = color.value_or(Numbers3{1, 1, 1})};
  found.anisotropy = std::clamp(gltfNumber(*scatter, "scatterAnisotropy").value_or(0), -0.99, 0.99);
  if (scatter == &later)
    found.isPartial = gltfNumber(later, "scatterStrengthFactor").value_or(1) < 1 ||
                      later.Has("scatterStrengthTexture");
  if (textured) found.texture = scatter->Get("multiscatterColorTexture");
  return found;
}

bool saysMediumByVolume(const tinygltf::Material& material) {
  return volumeOf(material).has_value();
}

namespace {

/// Whether light goes through it, though it does not say what a medium is.
bool letsLightThrough(const tinygltf::Material& material) {
  const auto above0 = [&](const char* name, const char* factor) {
    return gltfNumber(gltfExtension(material, name), factor).value_or(0) > 0;
  };
  return material.extensions.find("KHR_materials_volume_scatter") != material.extensions.end() ||
         above0("KHR_materials_scatter", "scatterStrengthFactor") ||
         (above0("KHR_materials_diffuse_transmission", "diffuseTransmissionFactor") &&
          above0("KHR_materials_volume", "thicknessFactor"));
}

}  // namespace

std::optional<Translucent> gltfMedium(const Input& input, const tinygltf::Model& model,
                                      int material, std::string_view meshName,
                                      std::string_view nodeName, GltfTextures& textures) {
  const tinygltf::Material none;
  if (material != -1 &&
      (material < 0 || static_cast<std::size_t>(material) >= model.materials.size())) {
    failGltf(input, fmt::format("material {} does not exist", material));
  }
  const tinygltf::Material& of =
      material < 0 ? none : model.materials[static_cast<std::size_t>(material)];
  std::optional<Medium> medium = fromExtras(of);
  for (const std::string_view name : {std::string_view(of.name), meshName, nodeName}) {
    if (!medium && !name.empty()) medium = findMedium(name);
  }
  const std::optional<Colors> colors = colorsOf(of, textures);
  if (!medium) medium = fromVolume(of, colors);
  if (!medium && letsLightThrough(of)) medium = defaultMedium();
  if (!medium) return std::nullopt;
  const std::string complaint = complaintAbout(*medium);
  if (!complaint.empty()) {
    failGltf(input, fmt::format("material '{}': {}", cleanText(of.name, 60), complaint));
  }
  std::optional<Paint> paint = paintOn(*medium, colors);
  return Translucent{std::move(*medium), std::move(paint)};
}

}  // namespace opaline::scene
