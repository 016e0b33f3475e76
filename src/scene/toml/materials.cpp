#include "scene/toml/materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/texture_file.h"
#include "opaline/error.h"
#include "opaline/file.h"
#include "scene/formats.h"
#include "scene/material.h"
#include "scene/text.h"
#include "scene/toml/keys.h"
#include "scene/toml/paths.h"

namespace opaline::scene {

namespace {

/// "base_color_texture" for the texture "base color".
std::string keyOf(const TextureOfMaterial& texture) {
  std::string key = fmt::format("{}_texture", texture.use);
  std::replace_if(
      key.begin(), key.end(), [](char c) { return c == ' ' || c == '-'; }, '_');
  return key;
}

struct TextureOfSurface {
  const char* key;
  std::optional<Texture> TranslucentSurface::*texture;
};

constexpr std::array<TextureOfSurface, 2> texturesOfSurface{
    {{"metallic_roughness_texture", &TranslucentSurface::metallicRoughnessTexture},
     {"normal_texture", &TranslucentSurface::normalTexture}}};

constexpr std::array<std::string_view, 7> keysOfTranslucent{
    "medium", "color", "color_texture", "color_model", "ball_mm", "mean_free_path_mm", "g"};

/// Refuses keys that only the other kind of material has.
void refuse(const TomlTable& table, std::string_view key, std::string_view kind) {
  if (table.has(key))
    table.fail(key, std::string("belongs to materials of kind \"") + std::string(kind) + "\"");
}

Texture readTextureOf(const TomlTable& table, const std::string& key,
                      const std::filesystem::path& path) {
  try {
    const std::vector<std::byte> bytes = readFile(path, longestFileBytes);
    Texture texture;
    texture.pixels = std::make_shared<const TexturePixels>(core::readTexture(path, bytes));
    return texture;
  } catch (const Error& error) {
    table.fail(key, fmt::format("names no texture that can be read: {}", error.what()));
  }
}

class MaterialReader {
 public:
  MaterialReader(const TomlTable& table, const std::filesystem::path& file, ColorModel colorModel,
                 const FindMedium& findMedium)
      : table_(table), file_(file), colorModel_(colorModel), findMedium_(findMedium) {}

  TomlMaterial read(const std::string& name) {
    table_.requireKeys(keys::material);
    constexpr std::array<std::string_view, 2> kinds{"opaque", "translucent"};
    const auto kind = table_.choice("kind", kinds);
    if (!kind) table_.fail("", "has no 'kind': opaque or translucent");
    made_.source.isOpaque = *kind == "opaque";
    if (made_.source.isOpaque) {
      readOpaque(name);
    } else {
      readTranslucent(name);
    }
    return std::move(made_);
  }

 private:
  std::optional<Texture> texture(const std::string& key) {
    const auto named = table_.text(key);
    if (!named) return std::nullopt;
    const std::filesystem::path path = beside(file_, *named);
    made_.source.textures.emplace(key, path);
    return readTextureOf(table_, key, path);
  }

  void readOpaque(const std::string& name) {
    for (const std::string_view key : keysOfTranslucent) refuse(table_, key, "translucent");
    refuse(table_, "eta", "translucent");
    OpaqueMaterial& material = made_.opaque.emplace();
    material.name = cleanText(name);
    made_.source.opaque = chosenIn<OpaqueMaterial>(table_);
    // Without a number beside it, a texture is shown unchanged.
    if (table_.has("base_color_texture")) material.baseColor = {1, 1, 1};
    if (table_.has("metallic_roughness_texture")) material.metallic = 1;
    if (table_.has("emission_texture")) material.emission = {1, 1, 1};
    if (table_.has("diffuse_transmission_texture")) material.diffuseTransmission = 1;
    made_.source.opaque.applyTo(material);
    for (const TextureOfMaterial& of : texturesOfMaterial)
      material.*of.texture = texture(keyOf(of));
  }

  void readTranslucent(const std::string& name) {
    for (const auto& field : options::fieldsOf<OpaqueMaterial>())
      if (options::findField<TranslucentSurface>(field.key) == nullptr)
        refuse(table_, field.key, "opaque");
    for (const TextureOfMaterial& of : texturesOfMaterial)
      if (std::none_of(texturesOfSurface.begin(), texturesOfSurface.end(),
                       [&](const TextureOfSurface& own) { return keyOf(of) == own.key; }))
        refuse(table_, keyOf(of), "opaque");
    readSurface();
    if (const auto medium = table_.text("medium")) {
      for (const char* key :
           {"color", "color_texture", "color_model", "ball_mm", "mean_free_path_mm", "g", "eta"})
        if (table_.has(key)) table_.fail(key, "cannot stand beside 'medium', which has its own");
      made_.source.medium = *medium;
      made_.translucent.medium = findMedium_(table_, "medium", *medium);
      return;
    }
    made_.source.appearance = chosenIn<Appearance>(table_);
    if (!made_.source.appearance.has("mean_free_path_mm"))
      table_.fail("", "needs 'medium', or 'mean_free_path_mm' beside 'color' or 'color_texture'");
    Appearance appearance;
    appearance.colorModel = colorModel_;
    if (table_.has("color_texture")) appearance.color = {1, 1, 1};
    made_.source.appearance.applyTo(appearance);
    if (const std::string complaint = complaintAbout(appearance); !complaint.empty())
      table_.fail("", complaint);
    std::optional<TranslucentSurface> surface = std::move(made_.translucent.surface);
    made_.translucent = bodyOf(appearance, texture("color_texture"));
    made_.translucent.surface = std::move(surface);
    if (made_.translucent.paint) made_.translucent.paint->name = cleanText(name);
    made_.translucent.medium.name = cleanText(name);
  }

  // Both kinds of material may give roughness and normals.
  void readSurface() {
    made_.source.surface = chosenIn<TranslucentSurface>(table_);
    TranslucentSurface surface;
    made_.source.surface.applyTo(surface);
    for (const auto& [key, member] : texturesOfSurface) surface.*member = texture(key);
    if (surface != TranslucentSurface{}) made_.translucent.surface = std::move(surface);
  }

  const TomlTable& table_;
  const std::filesystem::path& file_;
  ColorModel colorModel_;
  const FindMedium& findMedium_;
  TomlMaterial made_;
};

}  // namespace

std::map<std::string, TomlMaterial> readMaterials(const TomlTable& root,
                                                  const std::filesystem::path& file,
                                                  ColorModel colorModel,
                                                  const FindMedium& findMedium) {
  std::map<std::string, TomlMaterial> materials;
  const auto tables = root.table("materials");
  if (!tables) return materials;
  const auto all = tables->subtables();
  for (const auto& [name, table] : all)
    materials.emplace(name, MaterialReader(table, file, colorModel, findMedium).read(name));
  return materials;
}

}  // namespace opaline::scene
