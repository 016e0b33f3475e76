#include "scene/gltf/medium.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "opaline/media.h"
#include "opaline/tone.h"
#include "scene/gltf/json.h"
#include "scene/material.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

using Numbers3 = std::array<double, 3>;

double etaOf(const tinygltf::Material& material) {
  if (const auto eta = gltfNumber(material.extras, "eta")) return *eta;
  // Below 1.01 the dipole has no boundary. 1.5 is the default of KHR_materials_ior.
  const double ior = gltfNumber(gltfExtension(material, "KHR_materials_ior"), "ior").value_or(1.5);
  return std::clamp(ior, 1.01, 3.0);
}

/// Throws Error where extras that describe a medium are of the wrong type.
void requireExtras(const Input& input, const tinygltf::Material& material) {
  const tinygltf::Value& extras = material.extras;
  const auto fail = [&](const char* key, const char* what) {
    failGltf(input, fmt::format("material '{}': {} in its extras must be {}",
                                cleanText(material.name, 60), key, what));
  };
  const auto requireThree = [&](const char* key) {
    if (extras.Has(key) && !gltfNumbers<3>(extras, key)) fail(key, "three numbers");
  };
  for (const char* key : {"sigma_s_prime_per_mm", "sigma_a_per_mm"}) requireThree(key);
  if (extras.Has("sigma_s_prime_per_mm") != extras.Has("sigma_a_per_mm"))
    fail("sigma_s_prime_per_mm", "beside sigma_a_per_mm");
  constexpr const char* path = "mean_free_path_mm";
  if (extras.Has(path) && !gltfNumbers<3>(extras, path) && !gltfNumber(extras, path))
    fail(path, "a number or three");
  if (!extras.Has(path) && !extras.Has("sigma_a_per_mm")) return;  // somebody else's extras
  requireThree("color");
  for (const char* key : {"eta", "g", "ball_mm"})
    if (extras.Has(key) && !gltfNumber(extras, key)) fail(key, "a number");
}

std::optional<Medium> fromExtras(const tinygltf::Material& material) {
  const auto scattering = gltfNumbers<3>(material.extras, "sigma_s_prime_per_mm");
  const auto absorption = gltfNumbers<3>(material.extras, "sigma_a_per_mm");
  if (!scattering || !absorption) return std::nullopt;
  return Medium{cleanText(material.name), *scattering, *absorption, etaOf(material)};
}

/// The appearance in a material's extras. Programs that do not know glTF's media can write it as
/// custom properties. Without a color there, the base colour is used.
std::optional<Appearance> appearanceInExtras(const Input& input,
                                             const tinygltf::Material& material) {
  auto meanFreePath = gltfNumbers<3>(material.extras, "mean_free_path_mm");
  if (const auto all = gltfNumber(material.extras, "mean_free_path_mm"))
    meanFreePath = Numbers3{*all, *all, *all};
  if (!meanFreePath) return std::nullopt;
  Appearance appearance{.meanFreePathMm = *meanFreePath,
                        .g = gltfNumber(material.extras, "g").value_or(0),
                        .eta = std::min(etaOf(material), 1.6),
                        .colorModel = input.options.colorModel,
                        .ballMm = gltfNumber(material.extras, "ball_mm").value_or(0)};
  const std::vector<double>& base = material.pbrMetallicRoughness.baseColorFactor;
  const auto color = gltfNumbers<3>(material.extras, "color");
  for (std::size_t c = 0; c < 3; ++c)
    appearance.color[c] = color ? (*color)[c] : c < base.size() ? base[c] : 1.0;
  const std::string complaint = complaintAbout(appearance);
  if (!complaint.empty())
    failGltf(input, fmt::format("material '{}': {}", cleanText(material.name, 60), complaint));
  return appearance;
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

/// σ_t of the volume, per mm.
Numbers3 extinctionPerMm(const Volume& volume) {
  Numbers3 extinction{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double left = std::clamp(volume.attenuationColor[c], 1e-6, 0.9999);
    extinction[c] = -std::log(left) / (1000 * volume.attenuationDistance);
  }
  return extinction;
}

Appearance appearanceOf(const tinygltf::Material& material, const Volume& volume,
                        ColorModel model) {
  Appearance appearance{
      .g = volume.scattering.anisotropy, .eta = etaOf(material), .colorModel = model};
  const Numbers3 extinction = extinctionPerMm(volume);
  for (std::size_t c = 0; c < 3; ++c) {
    appearance.color[c] = std::clamp(volume.scattering.color[c], 0.0, 1.0);
    appearance.meanFreePathMm[c] = 1 / extinction[c];
  }
  return appearance;
}

std::optional<Translucent> fromVolume(const tinygltf::Material& material,
                                      std::optional<Texture> colors, ColorModel model) {
  const std::optional<Volume> volume = volumeOf(material);
  if (!volume) return std::nullopt;
  Translucent body = bodyOf(appearanceOf(material, *volume, model), std::move(colors));
  body.medium.name = cleanText(material.name);
  if (body.paint) body.paint->name = body.medium.name;
  return body;
}

}  // namespace

std::optional<GltfScattering> gltfScattering(const tinygltf::Material& material) {
  const auto number = [&](const char* extension, const char* key) {
    return gltfNumber(gltfExtension(material, extension), key).value_or(0);
  };
  const tinygltf::Value* scatter = &gltfExtension(material, "KHR_materials_volume_scatter");
  const tinygltf::Value& later = gltfExtension(material, "KHR_materials_scatter");
  const double strength = std::min(number("KHR_materials_scatter", "scatterStrengthFactor"), 1.0);
  const bool letsIn = number("KHR_materials_transmission", "transmissionFactor") > 0 &&
                      number("KHR_materials_volume", "thicknessFactor") > 0;
  const bool isLater = letsIn && strength > 0;
  if (isLater) scatter = &later;
  std::optional<Numbers3> color = gltfNumbers<3>(*scatter, "multiscatterColorFactor");
  if (!color) color = gltfNumbers<3>(*scatter, "multiscatterColor");
  const bool textured = scatter->Has("multiscatterColorTexture");
  if (!color && !textured && !isLater) return std::nullopt;
  GltfScattering found{.color = color.value_or(Numbers3{1, 1, 1})};
  found.anisotropy = std::clamp(gltfNumber(*scatter, "scatterAnisotropy").value_or(0), -0.99, 0.99);
  if (isLater) {
    for (double& channel : found.color) channel *= strength;
    if (later.Has("scatterStrengthTexture"))
      found.strengthTexture = later.Get("scatterStrengthTexture");
  }
  if (textured) found.texture = scatter->Get("multiscatterColorTexture");
  return found;
}

namespace {

/// Colours times the share that `shareOf` derives from their alpha. The result is opaque.
template <typename Share>
std::shared_ptr<const TexturePixels> scaled(const TexturePixels& colors, const Share& shareOf) {
  TexturePixels result = colors;
  for (std::size_t i = 0; i + 3 < result.rgba.size(); i += 4) {
    const float share = shareOf(static_cast<float>(result.rgba[i + 3]) / 65535.0F);
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint16_t& channel = result.rgba[i + c];
      const float linear = decodeSrgb(static_cast<float>(channel) / 65535.0F);
      channel = static_cast<std::uint16_t>(std::lround(65535 * encodeSrgb(share * linear)));
    }
    result.rgba[i + 3] = 65535;
  }
  return std::make_shared<const TexturePixels>(std::move(result));
}

double meanAlpha(const TexturePixels& pixels) {
  double sum = 0;
  for (std::size_t i = 3; i < pixels.rgba.size(); i += 4) sum += pixels.rgba[i];
  return 4 * sum / (65535 * std::max(static_cast<double>(pixels.rgba.size()), 1.0));
}

/// The texture of colours, multiplied by the texture of strengths.
std::optional<Texture> colorsOf(const GltfScattering& scattering, GltfTextures& textures) {
  std::optional<Texture> colors;
  std::optional<Texture> strengths;
  if (scattering.texture) colors = textures.texture(*scattering.texture);
  if (scattering.strengthTexture) strengths = textures.texture(*scattering.strengthTexture);
  if (!strengths) return colors;
  if (!colors) {  // the strengths are shades of grey
    TexturePixels white = *strengths->pixels;
    for (std::size_t i = 0; i < white.rgba.size(); ++i)
      if (i % 4 != 3) white.rgba[i] = 65535;
    strengths->pixels = scaled(white, [](float alpha) { return alpha; });
    return strengths;
  }
  const auto mean = static_cast<float>(meanAlpha(*strengths->pixels));
  const bool apart = scattering.texturesLieApart();
  colors->pixels = scaled(*colors->pixels, [&](float alpha) { return apart ? mean : alpha; });
  return colors;
}

}  // namespace

bool GltfScattering::texturesLieApart() const {
  if (!texture || !strengthTexture) return false;
  const auto same = [&](const char* key) {
    const bool has = texture->Has(key);
    return has == strengthTexture->Has(key) &&
           (!has || texture->Get(key) == strengthTexture->Get(key));
  };
  return !same("index") || !same("texCoord") || !same("extensions");
}

bool saysMediumByVolume(const tinygltf::Material& material) {
  return volumeOf(material).has_value();
}

namespace {

/// Whether light goes through the material, although it does not describe a medium.
bool letsLightThrough(const tinygltf::Material& material) {
  const auto above0 = [&](const char* name, const char* factor) {
    return gltfNumber(gltfExtension(material, name), factor).value_or(0) > 0;
  };
  return material.extensions.find("KHR_materials_volume_scatter") != material.extensions.end() ||
         (above0("KHR_materials_volume", "thicknessFactor") &&
          ((above0("KHR_materials_scatter", "scatterStrengthFactor") &&
            above0("KHR_materials_transmission", "transmissionFactor")) ||
           above0("KHR_materials_diffuse_transmission", "diffuseTransmissionFactor")));
}

std::optional<Medium> mediumNamed(std::string_view material, std::string_view mesh,
                                  std::string_view node) {
  for (const std::string_view name : {material, mesh, node}) {
    if (name.empty()) continue;
    if (auto medium = findMedium(name)) return medium;
  }
  return std::nullopt;
}

}  // namespace

bool saysMediumInExtras(const tinygltf::Material& material) {
  return fromExtras(material) || material.extras.Has("mean_free_path_mm");
}

bool baseColorIsOfMedium(const tinygltf::Material& material) {
  return !fromExtras(material) && material.extras.Has("mean_free_path_mm") &&
         !material.extras.Has("color");
}

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
  requireExtras(input, of);
  std::optional<Medium> medium = fromExtras(of);
  std::optional<Texture> colors;
  if (const auto scattering = gltfScattering(of)) colors = colorsOf(*scattering, textures);
  std::optional<Translucent> body;
  if (const auto appearance = appearanceInExtras(input, of); appearance && !medium) {
    if (baseColorIsOfMedium(of)) {
      const auto& base = of.pbrMetallicRoughness.baseColorTexture;
      colors = textures.texture(base.index, base.texCoord, base.extensions);
    }
    body = bodyOf(*appearance, colors);
    body->medium.name = cleanText(of.name);
    if (body->paint) body->paint->name = body->medium.name;
  }
  if (!medium && !body) medium = mediumNamed(of.name, meshName, nodeName);
  if (!medium && !body) body = fromVolume(of, colors, input.options.colorModel);
  if (!medium && !body && letsLightThrough(of)) medium = defaultMedium();
  if (medium) {
    body = {std::move(*medium), std::nullopt};
    if (colors) body->paint = paintOn(body->medium, std::move(*colors));
  }
  if (!body) return std::nullopt;
  const std::string complaint = complaintAbout(body->medium);
  if (!complaint.empty()) {
    failGltf(input, fmt::format("material '{}': {}", cleanText(of.name, 60), complaint));
  }
  return body;
}

std::optional<Medium> gltfMediumByVolume(const Input& input, const tinygltf::Material& material) {
  std::optional<Translucent> body = fromVolume(material, std::nullopt, input.options.colorModel);
  if (!body || !complaintAbout(body->medium).empty()) return std::nullopt;
  return std::move(body->medium);
}

}  // namespace opaline::scene
