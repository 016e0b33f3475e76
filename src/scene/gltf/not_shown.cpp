#include "scene/gltf/not_shown.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "scene/gltf/extensions.h"
#include "scene/gltf/medium.h"
#include "scene/gltf/mesh.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

bool isWhite(const std::vector<double>& factor) {
  const auto channels = static_cast<std::ptrdiff_t>(std::min<std::size_t>(factor.size(), 3));
  return std::all_of(factor.begin(), factor.begin() + channels, [](double c) { return c == 1; });
}

bool isBlack(const std::vector<double>& factor) {
  return std::all_of(factor.begin(), factor.end(), [](double c) { return c == 0; });
}

/// Whether the object's medium comes of these extensions.
bool isRead(const tinygltf::Material& material, std::string_view extension) {
  if (extension == "KHR_materials_volume" || extension == "KHR_materials_volume_scatter") {
    return saysMediumByVolume(material);
  }
  return kindOf(extension) == GltfExtension::Read;
}

void addMaterial(const tinygltf::Material& material, const std::string& name,
                 std::vector<NotShown>& to) {
  const auto add = [&](bool isThere, std::string_view what) {
    if (isThere) addNotShown(to, what, name);
  };
  const tinygltf::PbrMetallicRoughness& pbr = material.pbrMetallicRoughness;
  add(!isWhite(pbr.baseColorFactor), "base colours");
  add(pbr.baseColorTexture.index >= 0, "base-colour textures");
  add(pbr.metallicFactor > 0, "metals");
  add(pbr.metallicRoughnessTexture.index >= 0, "metallic-roughness textures");
  add(material.normalTexture.index >= 0, "normal textures");
  add(material.occlusionTexture.index >= 0, "occlusion textures");
  add(material.emissiveTexture.index >= 0 || !isBlack(material.emissiveFactor), "emission");
  add(material.alphaMode == "MASK" || material.alphaMode == "BLEND", "alpha");
  for (const auto& [extension, value] : material.extensions) {
    add(!isRead(material, extension), cleanText(extension, 60));
  }
}

std::string nameOr(const std::string& name, std::string_view kind, std::size_t index) {
  return name.empty() ? fmt::format("{} {}", kind, index) : name;
}

/// Of a mesh once, however often it is drawn.
void addMesh(const tinygltf::Model& model, std::size_t index, std::set<std::size_t>& materials,
             std::vector<NotShown>& to) {
  const tinygltf::Mesh& mesh = model.meshes[index];
  const std::string name = nameOr(mesh.name, "mesh", index);
  bool coloured = false;
  for (const tinygltf::Primitive& primitive : mesh.primitives) {
    if (!isSurface(primitive)) {
      addNotShown(to, "points and lines", name);
      continue;
    }
    coloured = coloured || primitive.attributes.find("COLOR_0") != primitive.attributes.end();
    const int material = primitive.material;
    if (material >= 0 && static_cast<std::size_t>(material) < model.materials.size()) {
      materials.insert(static_cast<std::size_t>(material));
    }
  }
  if (coloured) addNotShown(to, "vertex colours", name);
}

/// Beside those of materials, which are counted with these.
void addExtensions(const tinygltf::Model& model, std::vector<NotShown>& to) {
  for (const std::string& used : model.extensionsUsed) {
    if (kindOf(used) == GltfExtension::Unknown) {
      addNotShown(to, "extensions", used);
    }
  }
}

}  // namespace

std::vector<NotShown> notShownOf(const tinygltf::Model& model, const GltfNodes& nodes) {
  std::vector<NotShown> result;
  std::set<std::size_t> meshes;
  std::set<std::size_t> materials;
  for (const int node : nodes.drawn) {
    const tinygltf::Node& of = model.nodes[static_cast<std::size_t>(node)];
    if (of.mesh < 0 || static_cast<std::size_t>(of.mesh) >= model.meshes.size()) continue;
    const auto mesh = static_cast<std::size_t>(of.mesh);
    if (meshes.insert(mesh).second) addMesh(model, mesh, materials, result);
  }
  for (const std::size_t material : materials) {
    const tinygltf::Material& of = model.materials[material];
    addMaterial(of, nameOr(of.name, "material", material), result);
  }
  addExtensions(model, result);
  return result;
}

}  // namespace opaline::scene
