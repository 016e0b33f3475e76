#include "scene/gltf/material.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/gltf/json.h"
#include "scene/gltf/medium.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

float within(double value, double low, double high) {
  return static_cast<float>(value >= low ? std::min(value, high) : low);
}

Rgb color(const std::vector<double>& factor, double most = 1) {
  Rgb rgb{1, 1, 1};
  for (std::size_t c = 0; c < 3 && c < factor.size(); ++c) rgb[c] = within(factor[c], 0, most);
  return rgb;
}

constexpr double brightest = 1e29;

void readEmission(const tinygltf::Material& of, OpaqueMaterial& material) {
  const double strength =
      gltfNumber(gltfExtension(of, "KHR_materials_emissive_strength"), "emissiveStrength")
          .value_or(1);
  material.emission = {0, 0, 0};
  for (std::size_t c = 0; c < 3 && c < of.emissiveFactor.size(); ++c)
    material.emission[c] = within(of.emissiveFactor[c] * strength, 0, brightest);
}

void readSpecular(const tinygltf::Material& of, GltfTextures& textures, OpaqueMaterial& material) {
  const double ior = gltfNumber(gltfExtension(of, "KHR_materials_ior"), "ior").value_or(1.5);
  material.ior = ior == 0 ? 0.0F : within(ior, 1, 10);
  const tinygltf::Value& specular = gltfExtension(of, "KHR_materials_specular");
  material.specular = within(gltfNumber(specular, "specularFactor").value_or(1), 0, 1);
  if (const auto tint = gltfNumbers<3>(specular, "specularColorFactor"))
    material.specularColor = color({(*tint)[0], (*tint)[1], (*tint)[2]}, 1000);
  if (specular.Has("specularTexture"))
    material.specularTexture = textures.texture(specular.Get("specularTexture"));
  if (specular.Has("specularColorTexture"))
    material.specularColorTexture = textures.texture(specular.Get("specularColorTexture"));
}

void readDiffuseTransmission(const tinygltf::Material& of, GltfTextures& textures,
                             OpaqueMaterial& material) {
  const tinygltf::Value& through = gltfExtension(of, "KHR_materials_diffuse_transmission");
  material.diffuseTransmission =
      within(gltfNumber(through, "diffuseTransmissionFactor").value_or(0), 0, 1);
  if (const auto tint = gltfNumbers<3>(through, "diffuseTransmissionColorFactor"))
    material.diffuseTransmissionColor = color({(*tint)[0], (*tint)[1], (*tint)[2]});
  if (through.Has("diffuseTransmissionTexture"))
    material.diffuseTransmissionTexture =
        textures.texture(through.Get("diffuseTransmissionTexture"));
  if (through.Has("diffuseTransmissionColorTexture"))
    material.diffuseTransmissionColorTexture =
        textures.texture(through.Get("diffuseTransmissionColorTexture"));
}

/// A blended surface is shown where its alpha is at least one half.
float cutoffOf(const tinygltf::Material& of) {
  if (of.alphaMode == "MASK") return within(of.alphaCutoff, 0, 1);
  return of.alphaMode == "BLEND" ? 0.5F : 0.0F;
}

}  // namespace

OpaqueMaterial GltfMaterials::read(const tinygltf::Material& of) {
  const tinygltf::PbrMetallicRoughness& pbr = of.pbrMetallicRoughness;
  const auto texture = [&](const auto& info) {
    return textures_.texture(info.index, info.texCoord, info.extensions);
  };
  OpaqueMaterial material;
  material.name = cleanText(of.name);
  material.baseColor = color(pbr.baseColorFactor);
  material.alpha = pbr.baseColorFactor.size() > 3 ? within(pbr.baseColorFactor[3], 0, 1) : 1;
  material.baseColorTexture = texture(pbr.baseColorTexture);
  material.metallic = within(pbr.metallicFactor, 0, 1);
  material.roughness = within(pbr.roughnessFactor, 0, 1);
  material.metallicRoughnessTexture = texture(pbr.metallicRoughnessTexture);
  material.normalTexture = texture(of.normalTexture);
  material.normalScale = within(of.normalTexture.scale, -1000, 1000);
  material.occlusionTexture = texture(of.occlusionTexture);
  material.occlusionStrength = within(of.occlusionTexture.strength, 0, 1);
  material.emissionTexture = texture(of.emissiveTexture);
  material.alphaCutoff = cutoffOf(of);
  material.unlit = of.extensions.find("KHR_materials_unlit") != of.extensions.end();
  readEmission(of, material);
  readSpecular(of, textures_, material);
  readDiffuseTransmission(of, textures_, material);
  return material;
}

std::optional<TranslucentSurface> GltfMaterials::readSurface(const tinygltf::Material& of) {
  OpaqueMaterial all = read(of);
  // Roughness counts only where the file gives it: by default everything would be rough.
  const bool saysRoughness = of.values.contains("roughnessFactor");
  std::optional<TranslucentSurface> surface = scene::surfaceFrom(all);
  if (!saysRoughness) return surface;
  if (!surface) surface.emplace();
  surface->roughness = all.roughness;
  return surface;
}

std::set<int> GltfMaterials::opaque() const {
  std::set<int> materials;
  for (const auto& [index, material] : opaque_) materials.insert(index);
  return materials;
}

GltfSurface GltfMaterials::surface(int material, std::string_view meshName,
                                   std::string_view nodeName) {
  if (auto translucent = gltfMedium(input_, model_, material, meshName, nodeName, textures_)) {
    if (material >= 0)
      translucent->surface = readSurface(model_.materials[static_cast<std::size_t>(material)]);
    return {std::move(*translucent), std::nullopt};
  }
  if (material < 0) return {{defaultMedium(), std::nullopt}, std::nullopt};
  auto known = opaque_.find(material);
  if (known == opaque_.end()) {
    const tinygltf::Material& of = model_.materials[static_cast<std::size_t>(material)];
    known = opaque_.emplace(material, read(of)).first;
  }
  return {{defaultMedium(), std::nullopt}, known->second};
}

}  // namespace opaline::scene
