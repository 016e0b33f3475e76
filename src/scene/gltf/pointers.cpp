#include "scene/gltf/pointers.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numbers>

namespace opaline::scene {

namespace {

/// A property, and how many numbers it has.
struct Property {
  std::string_view name;
  std::size_t width;
};

constexpr std::array<Property, 21> ofMaterials{
    {{"alphaCutoff", 1},
     {"emissiveFactor", 3},
     {"normalTexture/scale", 1},
     {"occlusionTexture/strength", 1},
     {"pbrMetallicRoughness/baseColorFactor", 4},
     {"pbrMetallicRoughness/metallicFactor", 1},
     {"pbrMetallicRoughness/roughnessFactor", 1},
     {"extensions/KHR_materials_diffuse_transmission/diffuseTransmissionColorFactor", 3},
     {"extensions/KHR_materials_diffuse_transmission/diffuseTransmissionFactor", 1},
     {"extensions/KHR_materials_emissive_strength/emissiveStrength", 1},
     {"extensions/KHR_materials_ior/ior", 1},
     {"extensions/KHR_materials_scatter/multiscatterColorFactor", 3},
     {"extensions/KHR_materials_scatter/scatterAnisotropy", 1},
     {"extensions/KHR_materials_scatter/scatterStrengthFactor", 1},
     {"extensions/KHR_materials_specular/specularColorFactor", 3},
     {"extensions/KHR_materials_specular/specularFactor", 1},
     {"extensions/KHR_materials_volume/attenuationColor", 3},
     {"extensions/KHR_materials_volume/attenuationDistance", 1},
     {"extensions/KHR_materials_volume_scatter/multiscatterColor", 3},
     {"extensions/KHR_materials_volume_scatter/multiscatterColorFactor", 3},
     {"extensions/KHR_materials_volume_scatter/scatterAnisotropy", 1}}};

constexpr std::array<std::string_view, 9> textures{
    "pbrMetallicRoughness/baseColorTexture",
    "pbrMetallicRoughness/metallicRoughnessTexture",
    "normalTexture",
    "occlusionTexture",
    "emissiveTexture",
    "extensions/KHR_materials_diffuse_transmission/diffuseTransmissionTexture",
    "extensions/KHR_materials_diffuse_transmission/diffuseTransmissionColorTexture",
    "extensions/KHR_materials_specular/specularTexture",
    "extensions/KHR_materials_specular/specularColorTexture"};

constexpr std::string_view transform = "/extensions/KHR_texture_transform/";
constexpr std::array<Property, 3> ofTransforms{{{"offset", 2}, {"rotation", 1}, {"scale", 2}}};

constexpr std::array<Property, 4> ofLights{
    {{"color", 3}, {"intensity", 1}, {"spot/innerConeAngle", 1}, {"spot/outerConeAngle", 1}}};

constexpr std::array<Property, 2> ofCameras{{{"perspective/yfov", 1}, {"orthographic/ymag", 1}}};

template <std::size_t Count>
std::optional<std::size_t> widthIn(const std::array<Property, Count>& table,
                                   std::string_view name) {
  for (const Property& property : table)
    if (property.name == name) return property.width;
  return std::nullopt;
}

std::optional<std::size_t> widthOf(GltfPointer::Of of, std::string_view name) {
  if (of == GltfPointer::Of::Light) return widthIn(ofLights, name);
  if (of == GltfPointer::Of::Camera) return widthIn(ofCameras, name);
  if (const auto width = widthIn(ofMaterials, name)) return width;
  const std::size_t at = name.find(transform);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view texture = name.substr(0, at);
  if (std::find(textures.begin(), textures.end(), texture) == textures.end()) return std::nullopt;
  return widthIn(ofTransforms, name.substr(at + transform.size()));
}

/// The parts of a text between its slashes.
std::vector<std::string> partsOf(std::string_view path) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t slash = path.find('/');
    parts.emplace_back(path.substr(0, slash));
    if (slash == std::string_view::npos) return parts;
    path.remove_prefix(slash + 1);
  }
}

tinygltf::Value valueOf(std::span<const double> numbers) {
  if (numbers.size() == 1) return tinygltf::Value(numbers.front());
  tinygltf::Value::Array list;
  for (const double number : numbers) list.emplace_back(number);
  return tinygltf::Value(std::move(list));
}

/// Sets a value in an object, under the keys from `at` on.
void setIn(tinygltf::Value& object, const std::vector<std::string>& keys, std::size_t at,
           std::span<const double> numbers) {
  if (at == keys.size()) {
    object = valueOf(numbers);
    return;
  }
  if (!object.IsObject()) object = tinygltf::Value(tinygltf::Value::Object{});
  setIn(object.Get<tinygltf::Value::Object>()[keys[at]], keys, at + 1, numbers);
}

/// The same in something's extensions. The path begins with "extensions/".
void setIn(tinygltf::ExtensionMap& extensions, std::string_view path,
           std::span<const double> numbers) {
  const std::vector<std::string> keys = partsOf(path);
  setIn(extensions[keys.at(1)], keys, 2, numbers);
}

tinygltf::ExtensionMap* extensionsOfTexture(tinygltf::Material& material, std::string_view name) {
  if (name == textures[0]) return &material.pbrMetallicRoughness.baseColorTexture.extensions;
  if (name == textures[1])
    return &material.pbrMetallicRoughness.metallicRoughnessTexture.extensions;
  if (name == textures[2]) return &material.normalTexture.extensions;
  if (name == textures[3]) return &material.occlusionTexture.extensions;
  if (name == textures[4]) return &material.emissiveTexture.extensions;
  return nullptr;
}

}  // namespace

std::string pointerOf(const tinygltf::AnimationChannel& channel) {
  const auto found = channel.target_extensions.find(pointerExtension);
  if (found == channel.target_extensions.end() || !found->second.Has("pointer")) return {};
  const tinygltf::Value& pointer = found->second.Get("pointer");
  return pointer.IsString() ? pointer.Get<std::string>() : std::string{};
}

std::optional<GltfPointer> readPointer(const tinygltf::Model& model, std::string_view pointer) {
  struct Root {
    std::string_view start;
    GltfPointer::Of of;
    std::size_t count;
  };
  const std::array<Root, 3> roots{
      {{"/materials/", GltfPointer::Of::Material, model.materials.size()},
       {"/extensions/KHR_lights_punctual/lights/", GltfPointer::Of::Light, model.lights.size()},
       {"/cameras/", GltfPointer::Of::Camera, model.cameras.size()}}};
  for (const Root& root : roots) {
    if (!pointer.starts_with(root.start)) continue;
    const std::string rest(pointer.substr(root.start.size()));
    const std::size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
    if (digits == 0 || digits > 8 || digits == rest.size() || rest[digits] != '/')
      return std::nullopt;
    GltfPointer found{root.of, std::strtoul(rest.c_str(), nullptr, 10), rest.substr(digits + 1)};
    const auto width = widthOf(found.of, found.property);
    if (!width || found.index >= root.count) return std::nullopt;
    found.width = *width;
    return found;
  }
  return std::nullopt;
}

void setProperty(const GltfPointer& pointer, std::span<const double> numbers,
                 tinygltf::Material& material) {
  const std::string_view name = pointer.property;
  const std::vector<double> list(numbers.begin(), numbers.end());
  tinygltf::PbrMetallicRoughness& pbr = material.pbrMetallicRoughness;
  if (const std::size_t at = name.find(transform); at != std::string_view::npos)
    if (tinygltf::ExtensionMap* const extensions =
            extensionsOfTexture(material, name.substr(0, at)))
      return setIn(*extensions, name.substr(at + 1), numbers);
  if (name.starts_with("extensions/")) return setIn(material.extensions, name, numbers);
  if (name == "alphaCutoff") material.alphaCutoff = list[0];
  if (name == "emissiveFactor") material.emissiveFactor = list;
  if (name == "normalTexture/scale") material.normalTexture.scale = list[0];
  if (name == "occlusionTexture/strength") material.occlusionTexture.strength = list[0];
  if (name == "pbrMetallicRoughness/baseColorFactor") pbr.baseColorFactor = list;
  if (name == "pbrMetallicRoughness/metallicFactor") pbr.metallicFactor = list[0];
  if (name == "pbrMetallicRoughness/roughnessFactor") pbr.roughnessFactor = list[0];
}

void setProperty(const GltfPointer& pointer, std::span<const double> numbers,
                 tinygltf::Light& light) {
  constexpr double brightest = 1e29;
  constexpr double narrowest = 1e-4;
  const double number = numbers[0];
  const double angle = std::clamp(number, 0.0, std::numbers::pi / 2);
  if (pointer.property == "color") {
    light.color.clear();
    for (const double channel : numbers) light.color.push_back(std::clamp(channel, 0.0, brightest));
  } else if (pointer.property == "intensity") {
    light.intensity = std::clamp(number, 0.0, brightest);
  } else if (pointer.property == "spot/innerConeAngle") {
    light.spot.innerConeAngle = angle;
  } else {
    light.spot.outerConeAngle = std::max(angle, narrowest);
  }
}

void setProperty(const GltfPointer& pointer, std::span<const double> numbers,
                 tinygltf::Camera& camera) {
  constexpr double least = 1e-30;
  if (pointer.property == "perspective/yfov") camera.perspective.yfov = numbers[0];
  if (pointer.property == "orthographic/ymag")
    camera.orthographic.ymag = std::max(numbers[0], least);
}

}  // namespace opaline::scene
