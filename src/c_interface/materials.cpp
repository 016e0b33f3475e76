#include "opaline/material.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "c_interface/status.h"
#include "c_interface/values.h"

struct OpalinePixels : opaline::c::Handle<OpalinePixels> {
  std::shared_ptr<const opaline::TexturePixels> pixels;
};

namespace opaline::c {

namespace {

static_assert(static_cast<int>(TextureWrap::ClampToEdge) == OpalineWrapClampToEdge);

/// Widens to 16 bits; the largest number becomes the largest.
template <typename Stored>
void widen(const void* from, std::vector<std::uint16_t>& to) {
  constexpr int factor =
      std::numeric_limits<std::uint16_t>::max() / std::numeric_limits<Stored>::max();
  const auto* stored = static_cast<const Stored*>(from);
  for (std::uint16_t& value : to) value = static_cast<std::uint16_t>(factor * *stored++);
}

TexturePixels pixelsOf(const void* rgba, int bitsPerChannel, int width, int height) {
  requirePictureSize(width, height);
  required(static_cast<const std::byte*>(rgba), "rgba");
  TexturePixels pixels{.width = width, .height = height, .rgba = {}, .name = {}};
  pixels.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  if (bitsPerChannel == 8) {
    widen<std::uint8_t>(rgba, pixels.rgba);
  } else if (bitsPerChannel == 16) {
    widen<std::uint16_t>(rgba, pixels.rgba);
  } else {
    throw UsageError(fmt::format("bitsPerChannel {}: must be 8 or 16.", bitsPerChannel));
  }
  return pixels;
}

OpalineTexture given(const Texture& texture) {
  OpalineTexture whole{};
  whole.wrapU = static_cast<OpalineWrap>(texture.wrapU);
  whole.wrapV = static_cast<OpalineWrap>(texture.wrapV);
  whole.interpolated = texture.interpolated ? 1 : 0;
  whole.coordinates = texture.coordinates;
  for (std::size_t row = 0; row < 2; ++row)
    std::copy_n(texture.transform[row].begin(), 3, whole.transform + 3 * row);
  return whole;
}

std::optional<Texture> textureOf(const OpalineTexture* from) {
  if (!from) return std::nullopt;
  const OpalineTexture whole = wholeOf(from, given(Texture{}), "texture");
  Texture texture;
  texture.pixels = required(whole.pixels, "pixels").pixels;
  texture.wrapU = choiceOf<TextureWrap>(whole.wrapU, OpalineWrapClampToEdge, "wrap");
  texture.wrapV = choiceOf<TextureWrap>(whole.wrapV, OpalineWrapClampToEdge, "wrap");
  texture.interpolated = whole.interpolated != 0;
  texture.coordinates = whole.coordinates;
  for (std::size_t row = 0; row < 2; ++row)
    std::copy_n(whole.transform + 3 * row, 3, texture.transform[row].begin());
  return texture;
}

OpalineSurface given(const TranslucentSurface& surface) {
  OpalineSurface whole{};
  whole.normalScale = surface.normalScale;
  return whole;
}

TranslucentSurface surfaceOf(const OpalineSurface& from) {
  const OpalineSurface whole = wholeOf(&from, given(TranslucentSurface{}), "surface");
  TranslucentSurface surface;
  if (whole.roughness) surface.roughness = *whole.roughness;
  surface.metallicRoughnessTexture = textureOf(whole.metallicRoughnessTexture);
  surface.normalTexture = textureOf(whole.normalTexture);
  surface.normalScale = whole.normalScale;
  return sound(std::move(surface));
}

Paint paintOf(const OpalinePaint& from) {
  const OpalinePaint whole = wholeOf(&from, {}, "paint");
  return sound(Paint{.name = {},
                     .color = vectorOf(whole.color, "color"),
                     .colorTexture = textureOf(whole.colorTexture)});
}

// A number of an opaque material in both interfaces.
struct NumberOfMaterial {
  float OpaqueMaterial::*ours;
  float OpalineOpaqueMaterial::*given;
};
constexpr std::array<NumberOfMaterial, 9> numbers{
    {{&OpaqueMaterial::metallic, &OpalineOpaqueMaterial::metallic},
     {&OpaqueMaterial::roughness, &OpalineOpaqueMaterial::roughness},
     {&OpaqueMaterial::ior, &OpalineOpaqueMaterial::ior},
     {&OpaqueMaterial::specular, &OpalineOpaqueMaterial::specular},
     {&OpaqueMaterial::normalScale, &OpalineOpaqueMaterial::normalScale},
     {&OpaqueMaterial::occlusionStrength, &OpalineOpaqueMaterial::occlusionStrength},
     {&OpaqueMaterial::alphaCutoff, &OpalineOpaqueMaterial::alphaCutoff},
     {&OpaqueMaterial::alpha, &OpalineOpaqueMaterial::alpha},
     {&OpaqueMaterial::diffuseTransmission, &OpalineOpaqueMaterial::diffuseTransmission}}};

struct ColorOfMaterial {
  Rgb OpaqueMaterial::*ours;
  float (OpalineOpaqueMaterial::*given)[3];
};
constexpr std::array<ColorOfMaterial, 4> colors{
    {{&OpaqueMaterial::baseColor, &OpalineOpaqueMaterial::baseColor},
     {&OpaqueMaterial::specularColor, &OpalineOpaqueMaterial::specularColor},
     {&OpaqueMaterial::emission, &OpalineOpaqueMaterial::emission},
     {&OpaqueMaterial::diffuseTransmissionColor,
      &OpalineOpaqueMaterial::diffuseTransmissionColor}}};

// In the order of texturesOfMaterial.
constexpr std::array<const OpalineTexture * OpalineOpaqueMaterial::*, texturesOfMaterial.size()>
    textures{&OpalineOpaqueMaterial::baseColorTexture,
             &OpalineOpaqueMaterial::metallicRoughnessTexture,
             &OpalineOpaqueMaterial::specularTexture,
             &OpalineOpaqueMaterial::specularColorTexture,
             &OpalineOpaqueMaterial::normalTexture,
             &OpalineOpaqueMaterial::occlusionTexture,
             &OpalineOpaqueMaterial::emissionTexture,
             &OpalineOpaqueMaterial::diffuseTransmissionTexture,
             &OpalineOpaqueMaterial::diffuseTransmissionColorTexture};

OpalineOpaqueMaterial given(const OpaqueMaterial& material) {
  OpalineOpaqueMaterial whole{};
  for (const auto& [ours, given] : numbers) whole.*given = material.*ours;
  for (const auto& [ours, given] : colors) std::copy_n((material.*ours).begin(), 3, whole.*given);
  whole.unlit = material.unlit ? 1 : 0;
  return whole;
}

OpaqueMaterial opaqueOf(const OpalineOpaqueMaterial& from) {
  const OpalineOpaqueMaterial whole = wholeOf(&from, given(OpaqueMaterial{}), "material");
  OpaqueMaterial material;
  for (const auto& [ours, given] : numbers) material.*ours = whole.*given;
  for (const auto& [ours, given] : colors) std::copy_n(whole.*given, 3, (material.*ours).begin());
  for (std::size_t i = 0; i < textures.size(); ++i)
    material.*texturesOfMaterial[i].texture = textureOf(whole.*textures[i]);
  material.unlit = whole.unlit != 0;
  return sound(std::move(material));
}

/// Attributes of vertices. Throws unless there are as many as the mesh has vertices.
template <typename Vector>
std::vector<Vector> attributesOf(const Object& object, const float* values, std::size_t count,
                                 std::size_t strideBytes, const char* name) {
  if (count != object.mesh.positionsMm.size()) {
    throw UsageError(fmt::format("{} has {} vertices, but the object has {}.", name, count,
                                 object.mesh.positionsMm.size()));
  }
  return vectorsOf<Vector>(values, count, strideBytes, name);
}

}  // namespace
}  // namespace opaline::c

using namespace opaline;
using opaline::c::guarded;
using opaline::c::required;

extern "C" {

OpalineStatus opalineCreatePixels(const void* rgba, int32_t bitsPerChannel, int32_t width,
                                  int32_t height, OpalinePixels** pixels) {
  return guarded([&] {
    required(pixels, "pixels");
    *pixels = new OpalinePixels{
        {},
        std::make_shared<const TexturePixels>(c::pixelsOf(rgba, bitsPerChannel, width, height))};
  });
}

void opalineDestroyPixels(OpalinePixels* pixels) {
  c::destroy(pixels);
}

OpalineStatus opalineDefaultTexture(OpalineTexture* texture) {
  return guarded([&] { c::give(c::given(Texture{}), texture, "texture"); });
}

OpalineStatus opalineSetObjectTextureCoordinates(OpalineScene* scene, size_t object, int32_t set,
                                                 const float* coordinates, size_t vertexCount,
                                                 size_t strideBytes) {
  return guarded([&] {
    Object& of = c::objectOf(scene, object);
    if (set != 0 && set != 1)
      throw UsageError(fmt::format("set {}: texture coordinates have sets 0 and 1.", set));
    of.mesh.textureCoordinates[static_cast<std::size_t>(set)] =
        c::attributesOf<Vec2>(of, coordinates, vertexCount, strideBytes, "coordinates");
  });
}

OpalineStatus opalineSetObjectColors(OpalineScene* scene, size_t object, const float* rgba,
                                     size_t vertexCount, size_t strideBytes) {
  return guarded([&] {
    Object& of = c::objectOf(scene, object);
    of.mesh.colors =
        c::attributesOf<std::array<float, 4>>(of, rgba, vertexCount, strideBytes, "rgba");
  });
}

OpalineStatus opalineSetObjectPaint(OpalineScene* scene, size_t object, const OpalinePaint* paint) {
  return guarded([&] {
    c::objectOf(scene, object).paint =
        paint ? std::optional<Paint>(c::paintOf(*paint)) : std::nullopt;
  });
}

OpalineStatus opalineDefaultSurface(OpalineSurface* surface) {
  return guarded([&] { c::give(c::given(TranslucentSurface{}), surface, "surface"); });
}

OpalineStatus opalineSetObjectSurface(OpalineScene* scene, size_t object,
                                      const OpalineSurface* surface) {
  return guarded([&] {
    c::objectOf(scene, object).surface =
        surface ? std::optional<TranslucentSurface>(c::surfaceOf(*surface)) : std::nullopt;
  });
}

OpalineStatus opalineDefaultOpaqueMaterial(OpalineOpaqueMaterial* material) {
  return guarded([&] { c::give(c::given(OpaqueMaterial{}), material, "material"); });
}

OpalineStatus opalineSetObjectOpaque(OpalineScene* scene, size_t object,
                                     const OpalineOpaqueMaterial* material) {
  return guarded([&] {
    c::objectOf(scene, object).opaque =
        material ? std::optional<OpaqueMaterial>(c::opaqueOf(*material)) : std::nullopt;
  });
}

}  // extern "C"
