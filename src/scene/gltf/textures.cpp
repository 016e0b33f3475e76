#include "scene/gltf/textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "core/texture_file.h"
#include "opaline/error.h"
#include "opaline/file.h"
#include "scene/gltf/json.h"
#include "scene/gltf/prescan.h"
#include "scene/not_shown.h"
#include "scene/own_folder.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

constexpr const char* webpExtension = "EXT_texture_webp";

/// Most pixels of all pictures of one file.
constexpr std::size_t mostPixels = std::size_t{1} << 28U;

TextureWrap wrapOf(int mode) {
  if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return TextureWrap::ClampToEdge;
  if (mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return TextureWrap::MirroredRepeat;
  return TextureWrap::Repeat;
}

/// KHR_texture_transform: scaled, then turned, then moved.
void transformBy(const tinygltf::Value& transform, Texture& texture) {
  const auto pair = [&](const char* key, double missing) {
    const auto found = gltfNumbers<2>(transform, key);
    return found.value_or(std::array<double, 2>{missing, missing});
  };
  const auto offset = pair("offset", 0);
  const auto scale = pair("scale", 1);
  const double turn = gltfNumber(transform, "rotation").value_or(0);
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  const auto row = [](double x, double y, double z) {
    const auto number = [](double v) {
      constexpr double most = 1e6;
      return std::isnan(v) ? 0.0F : static_cast<float>(std::clamp(v, -most, most));
    };
    return Vec3{number(x), number(y), number(z)};
  };
  texture.transform = {row(c * scale[0], s * scale[1], offset[0]),
                       row(-s * scale[0], c * scale[1], offset[1])};
  if (const auto set = gltfIndex(transform, "texCoord")) texture.coordinates = *set;
}

}  // namespace

std::optional<Texture> GltfTextures::texture(int index, int coordinates,
                                             const tinygltf::ExtensionMap& with) {
  if (index == -1) return std::nullopt;
  if (index < 0 || static_cast<std::size_t>(index) >= model_.textures.size())
    failGltf(input_, fmt::format("texture {} does not exist", index));
  const tinygltf::Texture& of = model_.textures[static_cast<std::size_t>(index)];
  Texture texture;
  texture.pixels = pixelsOf(of);
  texture.coordinates = coordinates;
  if (!texture.pixels) return std::nullopt;
  if (of.sampler >= 0 && static_cast<std::size_t>(of.sampler) < model_.samplers.size()) {
    const tinygltf::Sampler& sampler = model_.samplers[static_cast<std::size_t>(of.sampler)];
    texture.wrapU = wrapOf(sampler.wrapS);
    texture.wrapV = wrapOf(sampler.wrapT);
    texture.interpolated = sampler.magFilter != TINYGLTF_TEXTURE_FILTER_NEAREST;
  }
  if (const auto found = with.find("KHR_texture_transform"); found != with.end())
    transformBy(found->second, texture);
  return texture;
}

std::optional<Texture> GltfTextures::texture(const tinygltf::Value& info) {
  const auto index = gltfIndex(info, "index");
  if (!index) return std::nullopt;
  tinygltf::ExtensionMap extensions;
  if (info.Has("extensions")) {
    const tinygltf::Value& list = info.Get("extensions");
    if (list.Has("KHR_texture_transform"))
      extensions["KHR_texture_transform"] = list.Get("KHR_texture_transform");
  }
  return texture(*index, gltfIndex(info, "texCoord").value_or(0), extensions);
}

std::shared_ptr<const TexturePixels> GltfTextures::pixelsOf(const tinygltf::Texture& texture) {
  const auto webp = texture.extensions.find(webpExtension);
  const bool hasFallback = texture.source >= 0;
  if (webp != texture.extensions.end()) {
    const int image = gltfIndex(webp->second, "source").value_or(-1);
    if (auto pixels = pixelsOf(image); pixels || !hasFallback) return pixels;
  }
  if (hasFallback) return pixelsOf(texture.source);
  std::string reason = "a texture has no picture that can be read";
  for (const auto& [extension, value] : texture.extensions)
    reason += fmt::format(", only one of {}", cleanText(extension, 60));
  leaveOut(texture.name, reason);
  return nullptr;
}

std::shared_ptr<const TexturePixels> GltfTextures::pixelsOf(int image) {
  if (const auto known = pixels_.find(image); known != pixels_.end()) return known->second;
  std::shared_ptr<const TexturePixels>& pixels = pixels_[image];
  if (image < 0 || static_cast<std::size_t>(image) >= model_.images.size())
    failGltf(input_, fmt::format("image {} does not exist", image));
  try {
    TexturePixels found = read(static_cast<std::size_t>(image));
    pixelsRead_ += found.rgba.size() / 4;
    if (pixelsRead_ > mostPixels)
      throw Error(fmt::format("its pictures have more than {} million pixels", mostPixels >> 20U));
    pixels = std::make_shared<const TexturePixels>(std::move(found));
  } catch (const Error& error) {
    leaveOut(nameOf(static_cast<std::size_t>(image)), error.what());
  }
  return pixels;
}

void GltfTextures::leaveOut(std::string_view name, const std::string& reason) {
  if (!leftOut_.insert(reason).second) return;
  addNotShown(unreadable_, "textures that cannot be read", name);
  note(input_.log,
       fmt::format("{}: a texture is left out: {}", cleanText(input_.file.string(), 1000), reason));
}

std::string GltfTextures::nameOf(std::size_t image) const {
  const tinygltf::Image& of = model_.images[image];
  const std::string named = !of.uri.empty() && !of.uri.starts_with("data:") ? of.uri : of.name;
  return named.empty() ? fmt::format("image {}", image) : cleanText(named, 100);
}

TexturePixels GltfTextures::read(std::size_t image) const {
  const tinygltf::Image& of = model_.images[image];
  const std::string name = nameOf(image);
  TexturePixels pixels;
  if (!of.image.empty()) {
    pixels = core::readTexture(name, std::as_bytes(std::span(of.image)));
  } else {
    const std::vector<std::byte> bytes =
        readFile(fileBeside(input_.file, percentDecoded(of.uri), "picture"), longestFileBytes);
    pixels = core::readTexture(name, bytes);
  }
  pixels.name = name;
  return pixels;
}

}  // namespace opaline::scene
