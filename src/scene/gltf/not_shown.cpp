#include "scene/gltf/not_shown.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "scene/gltf/extensions.h"
#include "scene/gltf/medium.h"
#include "scene/gltf/mesh.h"
#include "scene/not_shown.h"
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
  if (extension == "KHR_materials_volume" || extension == "KHR_materials_volume_scatter" ||
      extension == "KHR_materials_scatter") {
    return saysMediumByVolume(material);
  }
  // What goes through a medium goes through it by scattering.
  if (extension == "KHR_materials_transmission" ||
      extension == "KHR_materials_diffuse_transmission") {
    return saysMediumByVolume(material);
  }
  return kindOf(extension) == GltfExtension::Read;
}

HiddenParts partsOf(const tinygltf::Material& material) {
  const tinygltf::PbrMetallicRoughness& pbr = material.pbrMetallicRoughness;
  const bool usesColor = baseColorIsOfMedium(material);
  return {.baseColor = !usesColor && !isWhite(pbr.baseColorFactor),
          .baseColorTexture = !usesColor && pbr.baseColorTexture.index >= 0,
          .metal = pbr.metallicFactor > 0,
          .occlusionTexture = material.occlusionTexture.index >= 0,
          .emission = material.emissiveTexture.index >= 0 || !isBlack(material.emissiveFactor),
          .alphaMask = material.alphaMode == "MASK"};
}

void addMaterial(const tinygltf::Material& material, bool isTranslucent, const std::string& name,
                 std::vector<NotShown>& to) {
  if (isTranslucent) addNotShown(to, partsOf(material), name);
  const std::optional<GltfScattering> scattering = gltfScattering(material);
  if (scattering && scattering->texturesLieApart())
    addNotShown(to, "variations of scatter strength beside a colour texture", name);
  // Its surface ends where it is less there than not.
  if (material.alphaMode == "BLEND") addNotShown(to, "blended alpha", name);
  for (const auto& [extension, value] : material.extensions) {
    if (!isRead(material, extension)) addNotShown(to, cleanText(extension, 60), name);
  }
}

std::string nameOr(const std::string& name, std::string_view kind, std::size_t index) {
  return name.empty() ? fmt::format("{} {}", kind, index) : name;
}

/// Of a mesh once, however often it is drawn.
void addMesh(const tinygltf::Model& model, std::size_t index, const std::set<int>& opaque,
             std::set<std::size_t>& materials, std::vector<NotShown>& to) {
  const tinygltf::Mesh& mesh = model.meshes[index];
  const std::string name = nameOr(mesh.name, "mesh", index);
  bool coloured = false;
  for (const tinygltf::Primitive& primitive : mesh.primitives) {
    if (!isSurface(primitive)) {
      addNotShown(to, "points and lines", name);
      continue;
    }
    const int material = primitive.material;
    coloured = coloured || (!opaque.contains(material) &&
                            primitive.attributes.find("COLOR_0") != primitive.attributes.end());
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

std::vector<NotShown> notShownOf(const tinygltf::Model& model, const GltfNodes& nodes,
                                 const std::set<int>& opaque) {
  std::vector<NotShown> result;
  std::set<std::size_t> meshes;
  std::set<std::size_t> materials;
  for (const int node : nodes.drawn) {
    const tinygltf::Node& of = model.nodes[static_cast<std::size_t>(node)];
    if (of.mesh < 0 || static_cast<std::size_t>(of.mesh) >= model.meshes.size()) continue;
    const auto mesh = static_cast<std::size_t>(of.mesh);
    if (meshes.insert(mesh).second) addMesh(model, mesh, opaque, materials, result);
  }
  for (const std::size_t material : materials) {
    const tinygltf::Material& of = model.materials[material];
    addMaterial(of, !opaque.contains(static_cast<int>(material)),
                nameOr(of.name, "material", material), result);
  }
  addExtensions(model, result);
  return result;
}

}  // namespace opaline::scene
