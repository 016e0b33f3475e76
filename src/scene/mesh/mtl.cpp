#include "scene/mesh/mtl.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <sstream>
#include <vector>

#include "core/texture_file.h"
#include "opaline/error.h"
#include "opaline/file.h"
#include "scene/mesh/mtl_lines.h"
#include "scene/mesh/obj_lines.h"
#include "scene/not_shown.h"
#include "scene/own_folder.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

class MtlReader {
 public:
  MtlReader(const Input& obj, std::vector<NotShown>& unreadable)
      : obj_(obj), unreadable_(unreadable) {}

  void read(const std::string& file) {
    constexpr std::size_t longest = 64U << 20U;
    const std::vector<std::byte> bytes =
        readFile(fileBeside(obj_.file, file, "material file"), longest);
    MtlLines lines = mtlLines({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    std::istringstream stream(lines.text);
    std::map<std::string, int> indices;
    std::vector<tinyobj::material_t> found;
    std::string warning;
    std::string error;
    tinyobj::LoadMtl(&indices, &found, &stream, &warning, &error);
    for (const tinyobj::material_t& material : found) {
      // The library also gives a nameless one where there is none.
      if (material.name.empty() || materials_.contains(material.name)) continue;
      MtlMaterial read{convert(material), std::move(lines.notShown[material.name])};
      // The surface ends where alpha is below one half.
      if (read.shown.alpha > 0 && read.shown.alpha < 1) read.notShown.insert("blended alpha");
      materials_.emplace(material.name, std::move(read));
    }
  }

  MtlMaterials take() { return std::move(materials_); }

 private:
  static float within(float value, float most) { return value > 0 ? std::min(value, most) : 0.0F; }

  static Rgb color(const tinyobj::real_t* rgb, float most = 1) {
    return {within(rgb[0], most), within(rgb[1], most), within(rgb[2], most)};
  }

  OpaqueMaterial convert(const tinyobj::material_t& from) {
    OpaqueMaterial material;
    material.name = cleanText(from.name);
    material.baseColor = color(from.diffuse);
    material.baseColorTexture = texture(from.diffuse_texname, from.diffuse_texopt);
    material.metallic = within(from.metallic, 1);
    // As wide as Blinn's lobe of that exponent (Walter et al. 2007).
    material.roughness = from.roughness > 0
                             ? within(from.roughness, 1)
                             : std::pow(2 / (within(from.shininess, 1e6F) + 2), 0.25F);
    // Seen head-on, the surface mirrors Ks.
    constexpr float headOn = 0.04F;
    const Rgb mirrored = color(from.specular);
    material.specular = mirrored == Rgb{} ? 0.0F : 1.0F;
    for (std::size_t c = 0; c < 3; ++c) material.specularColor[c] = mirrored[c] / headOn;
    material.emission = color(from.emission, 1e30F);
    material.emissionTexture = texture(from.emissive_texname, from.emissive_texopt);
    if (material.emissionTexture && material.emission == Rgb{}) material.emission = {1, 1, 1};
    material.normalTexture = texture(from.normal_texname, from.normal_texopt);
    material.alpha = within(from.dissolve, 1);
    if (material.alpha < 1) material.alphaCutoff = 0.5F;
    return material;
  }

  std::optional<Texture> texture(const std::string& name, const tinyobj::texture_option_t& option) {
    if (name.empty()) return std::nullopt;
    Texture texture;
    texture.pixels = pixelsOf(name);
    if (!texture.pixels) return std::nullopt;
    if (option.clamp) texture.wrapU = texture.wrapV = TextureWrap::ClampToEdge;
    return texture;
  }

  std::shared_ptr<const TexturePixels> pixelsOf(const std::string& name) {
    if (const auto known = pixels_.find(name); known != pixels_.end()) return known->second;
    std::shared_ptr<const TexturePixels>& pixels = pixels_[name];
    try {
      const std::filesystem::path file = fileBeside(obj_.file, name, "picture");
      pixels = std::make_shared<const TexturePixels>(
          core::readTexture(file, readFile(file, longestFileBytes)));
    } catch (const Error& error) {
      addNotShown(unreadable_, "textures that cannot be read", name);
      note(obj_.log, fmt::format("{}: a texture is left out: {}",
                                 cleanText(obj_.file.string(), 1000), error.what()));
    }
    return pixels;
  }

  const Input& obj_;
  std::vector<NotShown>& unreadable_;
  MtlMaterials materials_;
  std::map<std::string, std::shared_ptr<const TexturePixels>> pixels_;  // null: could not be read
};

}  // namespace

std::vector<std::string> materialFilesOf(const Input& obj, const std::string& line) {
  const std::string folder = folderOf(obj.file);
  std::string refusal;
  const auto isFile = [&](const std::string& name) {
    return fileInFolder(folder, name, "material file", refusal).has_value();
  };
  if (isFile(line)) return {line};
  std::vector<std::string> names;
  std::string_view rest = line;
  for (std::string_view word = nextWord(rest); !word.empty() && !word.starts_with('#');
       word = nextWord(rest))
    names.emplace_back(word);
  if (std::none_of(names.begin(), names.end(), isFile)) return {line};
  return names;
}

MtlMaterials readMtl(const Input& obj, std::span<const std::string> files,
                     std::vector<NotShown>& unreadable) {
  MtlReader reader(obj, unreadable);
  for (const std::string& file : files) {
    try {
      reader.read(file);
    } catch (const Error& error) {
      note(obj.log, fmt::format("{}: materials are left out: {}",
                                cleanText(obj.file.string(), 1000), error.what()));
    }
  }
  return reader.take();
}

}  // namespace opaline::scene
