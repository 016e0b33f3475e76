#include "renderer/scene/opaque_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "gpu/device.h"
#include "gpu/transfer.h"
#include "passes/shade/gloss.h"
#include "renderer/scene/scene_tables.h"
#include "renderer/scene/texture_packer.h"
#include "scene/mesh/tangents.h"

namespace opaline {

namespace {

constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

bool readsAttributes(const Scene& scene) {
  bool any = false;
  for (const Object& object : scene.objects) {
    const std::optional<OpaqueMaterial> material = surfaceMaterialOf(object);
    if (!material) continue;
    // What has holes reads the alpha of its vertices.
    any = any || !object.mesh.colors.empty() || material->alphaCutoff > 0;
    for (const TextureOfMaterial& of : texturesOfMaterial) any = any || (*material).*of.texture;
  }
  return any;
}

// KHR_materials_ior: 0 stands for a surface that reflects everything.
float headOnReflectance(float ior) {
  const float part = ior == 0 ? 1 : (ior - 1) / (ior + 1);
  return part * part;
}

// Where a shader finds each texture of a material, in the order of texturesOfMaterial.
constexpr std::array<shared::TextureData shared::OpaqueData::*, texturesOfMaterial.size()>
    placesOfTextures{
        &shared::OpaqueData::baseColorTexture,   &shared::OpaqueData::metallicRoughnessTexture,
        &shared::OpaqueData::specularTexture,    &shared::OpaqueData::specularColorTexture,
        &shared::OpaqueData::normalTexture,      &shared::OpaqueData::occlusionTexture,
        &shared::OpaqueData::emissionTexture,    &shared::OpaqueData::throughTexture,
        &shared::OpaqueData::throughColorTexture};

shared::OpaqueData dataOf(const OpaqueMaterial& material, bool hasAttributes,
                          TexturePacker& packer) {
  shared::OpaqueData data{};
  data.rest = {0, material.unlit ? 1 : 0, hasAttributes ? 1 : 0, 0};
  for (std::size_t i = 0; i < texturesOfMaterial.size(); ++i)
    data.*placesOfTextures[i] =
        packer.add(material.*texturesOfMaterial[i].texture, texturesOfMaterial[i].meaning);
  setNumbers(material, data);
  return data;
}

// Whether the tables that these were made for have attributes of vertices.
bool haveAttributes(const std::vector<shared::OpaqueData>& data) {
  return !data.empty() && data.front().rest.z != 0;
}

std::vector<shared::VertexAttributes> attributesOf(const Scene& scene) {
  std::vector<shared::VertexAttributes> all;
  for (const Object& object : scene.objects) {
    const Mesh& mesh = object.mesh;
    const auto& [first, second] = mesh.textureCoordinates;
    for (std::size_t v = 0; v < mesh.positionsMm.size(); ++v) {
      const Vec2 a = first.empty() ? Vec2{} : first[v];
      const Vec2 b = second.empty() ? Vec2{} : second[v];
      const std::array<float, 4> color =
          mesh.colors.empty() ? std::array<float, 4>{1, 1, 1, 1} : mesh.colors[v];
      all.push_back({{a[0], a[1], b[0], b[1]}, {color[0], color[1], color[2], color[3]}});
    }
  }
  return all;
}

std::optional<Texture> normalTextureOf(const Object& object) {
  const std::optional<OpaqueMaterial> material = surfaceMaterialOf(object);
  return material ? material->normalTexture : std::nullopt;
}

void appendTangents(const Object& object, std::vector<shared::CornerTangents>& to) {
  const std::optional<Texture> texture = normalTextureOf(object);
  if (!texture) {
    to.resize(to.size() + object.mesh.triangles.size());
    return;
  }
  const auto set = static_cast<std::size_t>(texture->coordinates);
  for (const scene::TriangleTangents& of : scene::tangentsOf(object.mesh, set)) {
    const auto& [a, b, c] = of.corners;
    to.push_back({{a[0], a[1], b[0], b[1]}, {c[0], c[1], of.side, 0}});
  }
}

std::vector<shared::CornerTangents> tangentsOf(const Scene& scene) {
  std::vector<shared::CornerTangents> all;
  const bool any = std::any_of(scene.objects.begin(), scene.objects.end(),
                               [](const Object& o) { return normalTextureOf(o).has_value(); });
  if (!any) return all;
  for (const Object& object : scene.objects) appendTangents(object, all);
  return all;
}

std::vector<shared::vec4> glossLobes() {
  std::vector<shared::vec4> lobes;
  for (std::uint32_t i = 0; i < shared::glossLobeRows; ++i) {
    const double roughness = (i + 0.5) / shared::glossLobeRows;
    const std::vector<shared::vec4> row = reflectionLobes(roughness);
    lobes.insert(lobes.end(), row.begin(), row.end());
  }
  return lobes;
}

void noteHalvings(int halvings, const std::string& device, const LogCallback& log) {
  if (halvings == 0 || !log) return;
  log(LogLevel::Note,
      fmt::format("the textures are shown at 1/{} of their size, for which {} has room",
                  1 << halvings, device));
}

std::vector<shared::OpaqueData> dataOf(const std::vector<OpaqueMaterial>& materials,
                                       bool readsAttributes, TexturePacker& packer) {
  std::vector<shared::OpaqueData> data;
  data.reserve(materials.size());
  for (const OpaqueMaterial& material : materials)
    data.push_back(dataOf(material, readsAttributes, packer));
  return data;
}

}  // namespace

void setNumbers(const OpaqueMaterial& material, shared::OpaqueData& data) {
  const auto rgb = [](const Rgb& color, float w) {
    return shared::vec4(color[0], color[1], color[2], w);
  };
  data.baseColor = rgb(material.baseColor, material.alpha);
  data.emission = rgb(material.emission, material.alphaCutoff);
  data.surface = {material.metallic, material.roughness, headOnReflectance(material.ior),
                  material.specular};
  data.specularColor = rgb(material.specularColor, material.normalScale);
  data.rest.x = material.occlusionStrength;
  data.through = rgb(material.diffuseTransmissionColor, material.diffuseTransmission);
  for (std::size_t i = 0; i < texturesOfMaterial.size(); ++i)
    if (const auto& texture = material.*texturesOfMaterial[i].texture)
      TexturePacker::setTransform(*texture, data.*placesOfTextures[i]);
}

bool isPainted(const Object& object) {
  return !object.opaque && object.paint;
}

bool hasOwnSurface(const Object& object) {
  return !object.opaque && object.surface;
}

bool hasOwnNormals(const Object& object) {
  return hasOwnSurface(object) && object.surface->normalTexture;
}

std::optional<OpaqueMaterial> surfaceMaterialOf(const Object& object) {
  if (!isPainted(object) && !hasOwnSurface(object)) return object.opaque;
  OpaqueMaterial material;
  material.roughness = -1;
  if (isPainted(object)) {
    material.name = object.paint->name;
    material.baseColor = object.paint->color;
    material.baseColorTexture = object.paint->colorTexture;
  }
  if (hasOwnSurface(object)) {
    const TranslucentSurface& surface = *object.surface;
    material.roughness =
        surface.roughness.value_or(surface.metallicRoughnessTexture ? 1.0F : -1.0F);
    material.metallicRoughnessTexture = surface.metallicRoughnessTexture;
    material.normalTexture = surface.normalTexture;
    material.normalScale = surface.normalScale;
  }
  return material;
}

passes::OpaqueTables makeOpaqueTables(gpu::Device& device, const Scene& scene,
                                      const std::vector<OpaqueMaterial>& materials,
                                      std::optional<TexturePacker>& packer, const LogCallback& log,
                                      std::vector<shared::OpaqueData>& onHost) {
  packer.reset();
  onHost.clear();
  passes::OpaqueTables tables;
  // Buffers have to be bound even if there are no materials.
  if (materials.empty()) {
    for (gpu::Buffer* buffer : {&tables.materials, &tables.texels, &tables.attributes,
                                &tables.tangents, &tables.gloss, &tables.lobes})
      *buffer = gpu::makeBuffer(device, "no materials", std::vector<float>{}, storage);
    return tables;
  }
  packer.emplace(device.limits().maxStorageBufferRange / sizeof(TexturePacker::Texel));
  for (const OpaqueMaterial& material : materials)
    for (const TextureOfMaterial& of : texturesOfMaterial)
      packer->announce(material.*of.texture, of.meaning);
  noteHalvings(packer->halvings(), device.info().name, log);
  const bool reads = readsAttributes(scene);
  onHost = dataOf(materials, reads, *packer);
  tables.materials = gpu::makeBuffer(device, "opaque materials", onHost, storage);
  tables.texels = gpu::makeBuffer(device, "texels", packer->texels(), storage);
  packer->forgetTexels();
  tables.attributes = gpu::makeBuffer(
      device, "attributes of vertices",
      reads ? attributesOf(scene) : std::vector<shared::VertexAttributes>{}, storage);
  tables.tangents = gpu::makeBuffer(device, "tangents of triangles", tangentsOf(scene), storage);
  tables.gloss = gpu::makeBuffer(device, "gloss", passes::glossTable(), storage);
  tables.lobes = gpu::makeBuffer(device, "lobes of gloss", glossLobes(), storage);
  return tables;
}

bool retakeMaterials(gpu::Device& device, const Scene& scene,
                     const std::vector<OpaqueMaterial>& materials,
                     std::optional<TexturePacker>& packer, passes::OpaqueTables& tables,
                     std::vector<shared::OpaqueData>& onHost) {
  if (!packer || materials.empty()) return false;
  for (const OpaqueMaterial& material : materials)
    for (const TextureOfMaterial& of : texturesOfMaterial)
      if (const auto& texture = material.*of.texture;
          texture && !packer->knows(*texture->pixels, of.meaning))
        return false;
  const bool reads = readsAttributes(scene);
  if (reads && !haveAttributes(onHost)) return false;
  onHost = dataOf(materials, reads, *packer);
  tables.materials = gpu::makeBuffer(device, "opaque materials", onHost, storage);
  return true;
}

}  // namespace opaline
