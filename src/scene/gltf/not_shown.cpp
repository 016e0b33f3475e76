#include "scene/gltf/not_shown.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "scene/gltf/draft.h"
#include "scene/gltf/extensions.h"
#include "scene/gltf/json.h"
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

/// Whether the object is shown as this extension asks.
bool isRead(const tinygltf::Material& material, bool isTranslucent, std::string_view extension) {
  if (extension == "KHR_materials_volume" || extension == "KHR_materials_volume_scatter" ||
      extension == "KHR_materials_scatter") {
    return saysMediumByVolume(material);
  }
  // A medium passes light on by scattering only.
  if (extension == "KHR_materials_transmission") return saysMediumByVolume(material);
  if (extension == "KHR_materials_diffuse_transmission")
    return !isTranslucent || saysMediumByVolume(material);
  return kindOf(extension) == GltfExtension::Read;
}

/// What two extensions say about how light enters a body.
struct WayIn {
  double clear = 0;    ///< of KHR_materials_transmission, tinted by the base colour
  double diffuse = 0;  ///< of KHR_materials_diffuse_transmission, of the rest
  bool isSaid = false;

  double share() const { return 1 - (1 - clear) * (1 - diffuse); }
};

WayIn wayInto(const tinygltf::Material& material) {
  const auto factor = [&](const char* extension, const char* key) {
    return std::clamp(gltfNumber(gltfExtension(material, extension), key).value_or(0), 0.0, 1.0);
  };
  return {factor("KHR_materials_transmission", "transmissionFactor"),
          factor("KHR_materials_diffuse_transmission", "diffuseTransmissionFactor"),
          material.extensions.contains("KHR_materials_transmission") ||
              material.extensions.contains("KHR_materials_diffuse_transmission")};
}

/// Whether nothing of the base colour is lost in a medium. Where all light enters diffusely, none
/// is reflected in the base colour. Where the medium uses the same picture, the base colour is
/// there for readers that know no media.
bool losesNoBaseColor(const tinygltf::Material& material) {
  if (baseColorIsOfMedium(material)) return true;
  const WayIn in = wayInto(material);
  if (in.clear == 0 && in.diffuse == 1) return true;
  const std::optional<GltfScattering> scattering = gltfScattering(material);
  return scattering && scattering->texture &&
         gltfIndex(*scattering->texture, "index") ==
             material.pbrMetallicRoughness.baseColorTexture.index;
}

/// Adds what a medium cannot show of these extensions. It takes in all light that its surface does
/// not mirror, everywhere and whatever the light's colour.
void addWayIn(const tinygltf::Material& material, const std::string& name,
              std::vector<NotShown>& to) {
  if (!saysMediumByVolume(material)) return;
  const WayIn in = wayInto(material);
  if (in.isSaid && in.share() < 1) addNotShown(to, "partial transmission", name);
  const tinygltf::Value& clear = gltfExtension(material, "KHR_materials_transmission");
  const tinygltf::Value& diffuse = gltfExtension(material, "KHR_materials_diffuse_transmission");
  if (clear.Has("transmissionTexture") || diffuse.Has("diffuseTransmissionTexture"))
    addNotShown(to, "textures of transmission", name);
  const auto tint = gltfNumbers<3>(diffuse, "diffuseTransmissionColorFactor");
  if ((tint && *tint != std::array<double, 3>{1, 1, 1}) ||
      diffuse.Has("diffuseTransmissionColorTexture"))
    addNotShown(to, "colours of diffuse transmission", name);
}

HiddenParts partsOf(const tinygltf::Material& material) {
  const tinygltf::PbrMetallicRoughness& pbr = material.pbrMetallicRoughness;
  const bool isShown = losesNoBaseColor(material);
  return {.baseColor = !isShown && !isWhite(pbr.baseColorFactor),
          .baseColorTexture = !isShown && pbr.baseColorTexture.index >= 0,
          .metal = pbr.metallicFactor > 0,
          .occlusionTexture = material.occlusionTexture.index >= 0,
          .emission = material.emissiveTexture.index >= 0 || !isBlack(material.emissiveFactor),
          .alphaMask = material.alphaMode == "MASK"};
}

void addMaterial(const tinygltf::Material& material, bool isTranslucent, const std::string& name,
                 std::vector<NotShown>& to) {
  if (isTranslucent) {
    addNotShown(to, partsOf(material), name);
    addWayIn(material, name, to);
  }
  const std::optional<GltfScattering> scattering = gltfScattering(material);
  if (scattering && scattering->texturesLieApart())
    addNotShown(to, "variations of scatter strength beside a colour texture", name);
  // A medium's surface ends where alpha is below one half.
  if (material.alphaMode == "BLEND") addNotShown(to, "blended alpha", name);
  for (const auto& [extension, value] : material.extensions) {
    if (!isRead(material, isTranslucent, extension))
      addNotShown(to, cleanText(extension, 60), name);
  }
}

std::string nameOr(const std::string& name, std::string_view kind, std::size_t index) {
  return name.empty() ? fmt::format("{} {}", kind, index) : name;
}

/// Whether indices are left over that make no triangle (glTF 2.0, section 3.7.2.1).
bool hasIncompleteTriangle(const tinygltf::Model& model, const tinygltf::Primitive& primitive) {
  const int accessor = primitive.indices >= 0
                           ? primitive.indices
                           : attribute(primitive.attributes, "POSITION").value_or(-1);
  if (accessor < 0 || static_cast<std::size_t>(accessor) >= model.accessors.size()) return false;
  const std::size_t corners = model.accessors[static_cast<std::size_t>(accessor)].count;
  return primitive.mode == TINYGLTF_MODE_TRIANGLES ? corners % 3 != 0 : corners < 3;
}

constexpr const char* variants = "KHR_materials_variants";

/// Adds each mesh once, however often it is drawn.
void addMesh(const tinygltf::Model& model, std::size_t index, const std::set<int>& opaque,
             std::set<std::size_t>& materials, std::vector<NotShown>& to) {
  const tinygltf::Mesh& mesh = model.meshes[index];
  const std::string name = nameOr(mesh.name, "mesh", index);
  bool coloured = false;
  bool varies = false;
  for (const tinygltf::Primitive& primitive : mesh.primitives) {
    if (!isSurface(primitive)) {
      addNotShown(to, "points and lines", name);
      continue;
    }
    if (hasIncompleteTriangle(model, primitive)) addNotShown(to, "incomplete triangles", name);
    const int material = primitive.material;
    varies = varies || primitive.extensions.contains(variants);
    coloured = coloured || (!opaque.contains(material) &&
                            primitive.attributes.find("COLOR_0") != primitive.attributes.end());
    if (material >= 0 && static_cast<std::size_t>(material) < model.materials.size()) {
      materials.insert(static_cast<std::size_t>(material));
    }
  }
  if (coloured) addNotShown(to, "vertex colours", name);
  if (varies) addNotShown(to, variants, name);
}

/// Adds extensions outside materials too; those of materials are counted with them.
void addExtensions(const tinygltf::Model& model, std::vector<NotShown>& to) {
  for (const std::string& used : model.extensionsUsed) {
    const bool isSaid = std::any_of(to.begin(), to.end(), [&](const NotShown& kind) {
      return kind.what == cleanText(used, 60);
    });
    if (!isSaid && kindOf(used) == GltfExtension::Unknown) addNotShown(to, "extensions", used);
  }
}

/// A file may hold several scenes, of which one is drawn.
void addScenes(const tinygltf::Model& model, std::vector<NotShown>& to) {
  const auto drawn = static_cast<std::size_t>(std::max(model.defaultScene, 0));
  for (std::size_t i = 0; i < model.scenes.size(); ++i)
    if (i != drawn) addNotShown(to, "other scenes", model.scenes[i].name);
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
  addScenes(model, result);
  return result;
}

}  // namespace opaline::scene
