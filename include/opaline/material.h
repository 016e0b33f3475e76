#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "opaline/export.h"
#include "opaline/image.h"
#include "opaline/types.h"

namespace opaline {

/// How a texture goes on outside of [0, 1].
enum class TextureWrap { Repeat, MirroredRepeat, ClampToEdge };

/// A picture that varies a number of a material over the surface.
struct Texture {
  std::shared_ptr<const TexturePixels> pixels;  ///< never null; copies share it
  TextureWrap wrapU = TextureWrap::Repeat;
  TextureWrap wrapV = TextureWrap::Repeat;
  bool interpolated = true;  ///< false: a pixel of the picture that is seen large has sharp edges
  int coordinates = 0;       ///< which of Mesh::textureCoordinates, 0 or 1
  /// From these to the place in the picture, (0, 0) being its upper left corner: rows of an affine
  /// map.
  std::array<Vec3, 2> transform{{{1, 0, 0}, {0, 1, 0}}};

  bool operator==(const Texture&) const = default;
};

/// A surface without an inside: metallic-roughness as in glTF 2.0, section 3.9, with
/// KHR_materials_ior, KHR_materials_specular, KHR_materials_emissive_strength,
/// KHR_materials_unlit and, as a sheet without thickness has it,
/// KHR_materials_diffuse_transmission. A texture multiplies the number beside it.
struct OpaqueMaterial {
  std::string name;
  Rgb baseColor{0.5F, 0.5F,
                0.5F};  ///< in [0, 1]; share of light given back diffusely, or by a metal
  std::optional<Texture> baseColorTexture;          ///< rgb: sRGB; a: alpha
  float metallic = 0;                               ///< in [0, 1]
  float roughness = 1;                              ///< of the reflection, in [0, 1]
  std::optional<Texture> metallicRoughnessTexture;  ///< g: roughness, b: metallic, linear
  float ior = 1.5F;                                 ///< in [1, 10], or 0, by which all is reflected
  float specular = 1;          ///< strength of the reflection of what is no metal, in [0, 1]
  Rgb specularColor{1, 1, 1};  ///< of that, head on, in [0, 1e3]
  std::optional<Texture> specularTexture;       ///< a: strength, linear
  std::optional<Texture> specularColorTexture;  ///< rgb: sRGB
  std::optional<Texture> normalTexture;         ///< tangent space, green up, linear
  float normalScale = 1;                        ///< of its x and y
  std::optional<Texture> occlusionTexture;      ///< r: share of indirect light, linear
  float occlusionStrength = 1;                  ///< in [0, 1]
  Rgb emission{};                               ///< radiance, in [0, 1e30]
  std::optional<Texture> emissionTexture;       ///< rgb: sRGB
  float alphaCutoff = 0;  ///< in [0, 1]; where alpha is less there is no surface
  float alpha = 1;        ///< in [0, 1]
  bool unlit = false;     ///< its radiance is the base colour, whatever the light
  /// In [0, 1]: so much of the light that would be given back diffusely goes through instead, and
  /// leaves the other side diffusely.
  float diffuseTransmission = 0;
  std::optional<Texture> diffuseTransmissionTexture;       ///< a: share, linear
  Rgb diffuseTransmissionColor{1, 1, 1};                   ///< of what goes through, in [0, 1]
  std::optional<Texture> diffuseTransmissionColorTexture;  ///< rgb: sRGB

  bool operator==(const OpaqueMaterial&) const = default;
};

/// What the numbers of a texture are.
enum class TexelMeaning {
  Color,   ///< sRGB, alpha linear
  Number,  ///< linear
  Normal   ///< a unit vector, each from -1 to 1
};

/// A texture that a material may have.
struct TextureOfMaterial {
  std::string_view use;  ///< "base color"
  std::optional<Texture> OpaqueMaterial::*texture;
  TexelMeaning meaning;
};

/// All of them.
inline constexpr std::array<TextureOfMaterial, 9> texturesOfMaterial{
    {{"base color", &OpaqueMaterial::baseColorTexture, TexelMeaning::Color},
     {"metallic-roughness", &OpaqueMaterial::metallicRoughnessTexture, TexelMeaning::Number},
     {"specular", &OpaqueMaterial::specularTexture, TexelMeaning::Number},
     {"specular color", &OpaqueMaterial::specularColorTexture, TexelMeaning::Color},
     {"normal", &OpaqueMaterial::normalTexture, TexelMeaning::Normal},
     {"occlusion", &OpaqueMaterial::occlusionTexture, TexelMeaning::Number},
     {"emission", &OpaqueMaterial::emissionTexture, TexelMeaning::Color},
     {"diffuse transmission", &OpaqueMaterial::diffuseTransmissionTexture, TexelMeaning::Number},
     {"diffuse transmission color", &OpaqueMaterial::diffuseTransmissionColorTexture,
      TexelMeaning::Color}}};

/// Why the material cannot be rendered, as a sentence; empty if it can.
OPALINE_API std::string complaintAbout(const OpaqueMaterial& material);

/// A matt surface that gives back the same share of light in all directions.
OPALINE_API OpaqueMaterial mattMaterial(const Rgb& color);

/// Colours on a translucent body: a layer on its surface that absorbs as much as its medium needs
/// to be seen in them. They are shares of the light that entered which leave again in even light,
/// as those of an Appearance, of a thick body; where they are brighter than colorOf its medium,
/// they are that. Colours of its vertices multiply them.
struct Paint {
  static constexpr float mostColor = 100;  ///< of a dark texture

  std::string name;
  Rgb color{1, 1, 1};                   ///< in [0, mostColor]
  std::optional<Texture> colorTexture;  ///< rgb: sRGB, multiplies the color

  bool operator==(const Paint&) const = default;
};

/// The surface of a translucent body, as rough and as uneven as it is: both shape what it mirrors,
/// and normals also where light enters. A texture multiplies the number beside it.
struct TranslucentSurface {
  /// Of the reflection, in [0, 1]; none: RenderOptions::roughness, or 1 beside a texture.
  std::optional<float> roughness;
  std::optional<Texture> metallicRoughnessTexture;  ///< g: roughness, linear; the rest is not read
  std::optional<Texture> normalTexture;             ///< tangent space, green up, linear
  float normalScale = 1;                            ///< of its x and y

  bool operator==(const TranslucentSurface&) const = default;
};

/// All textures that such a surface may have.
inline constexpr std::array<std::optional<Texture> TranslucentSurface::*, 2>
    texturesOfTranslucentSurface{&TranslucentSurface::metallicRoughnessTexture,
                                 &TranslucentSurface::normalTexture};

/// Why the surface cannot be rendered, as a sentence; empty if it can.
OPALINE_API std::string complaintAbout(const TranslucentSurface& surface);

/// Why the paint cannot be rendered, as a sentence; empty if it can.
OPALINE_API std::string complaintAbout(const Paint& paint);

}  // namespace opaline
