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
  bool interpolated = true;  ///< false: magnified pixels have sharp edges
  int coordinates = 0;       ///< which of Mesh::textureCoordinates, 0 or 1
  /// Rows of an affine map from these to the picture, whose upper left corner is at (0, 0).
  std::array<Vec3, 2> transform{{{1, 0, 0}, {0, 1, 0}}};

  bool operator==(const Texture&) const = default;
};

/// A surface without an inside: metallic-roughness as in glTF 2.0, section 3.9, with
/// KHR_materials_ior, KHR_materials_specular, KHR_materials_emissive_strength,
/// KHR_materials_unlit and, for a sheet without thickness, KHR_materials_diffuse_transmission. A
/// texture multiplies the number beside it.
struct OpaqueMaterial {
  std::string name;
  Rgb baseColor{0.5F, 0.5F,
                0.5F};  ///< in [0, 1]; share of light reflected diffusely, or by a metal
  std::optional<Texture> baseColorTexture;          ///< rgb: sRGB; a: alpha
  float metallic = 0;                               ///< in [0, 1]
  float roughness = 1;                              ///< of the reflection, in [0, 1]
  std::optional<Texture> metallicRoughnessTexture;  ///< g: roughness, b: metallic, linear
  float ior = 1.5F;                                 ///< in [1, 10], or 0: everything is reflected
  float specular = 1;                      ///< strength of a dielectric's reflection, in [0, 1]
  Rgb specularColor{1, 1, 1};              ///< of that reflection at normal incidence, in [0, 1e3]
  std::optional<Texture> specularTexture;  ///< a: strength, linear
  std::optional<Texture> specularColorTexture;  ///< rgb: sRGB
  std::optional<Texture> normalTexture;         ///< tangent space, green up, linear
  float normalScale = 1;                        ///< factor of the texture's x and y
  std::optional<Texture> occlusionTexture;      ///< r: share of indirect light, linear
  float occlusionStrength = 1;                  ///< in [0, 1]
  Rgb emission{};                               ///< radiance, in [0, 1e30]
  std::optional<Texture> emissionTexture;       ///< rgb: sRGB
  float alphaCutoff = 0;  ///< in [0, 1]; where alpha is less there is no surface
  float alpha = 1;        ///< in [0, 1]
  bool unlit = false;     ///< its radiance is the base colour under any light
  /// Share in [0, 1] of the diffusely reflected light that passes through instead, and leaves the
  /// other side diffusely.
  float diffuseTransmission = 0;
  std::optional<Texture> diffuseTransmissionTexture;  ///< a: share, linear
  Rgb diffuseTransmissionColor{1, 1, 1};  ///< of the light that passes through, in [0, 1]
  std::optional<Texture> diffuseTransmissionColorTexture;  ///< rgb: sRGB

  bool operator==(const OpaqueMaterial&) const = default;
};

/// What the numbers of a texture are.
enum class TexelMeaning {
  Color,   ///< sRGB, alpha linear
  Number,  ///< linear
  Normal   ///< a unit vector with components from -1 to 1
};

/// A texture that a material may have.
struct TextureOfMaterial {
  std::string_view use;  ///< "base color"
  std::optional<Texture> OpaqueMaterial::*texture;
  TexelMeaning meaning;
};

/// All textures that an opaque material may have.
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

/// A matt surface that reflects the same radiance in all directions.
OPALINE_API OpaqueMaterial mattMaterial(const Rgb& color);

/// Colours on a translucent body: a layer on its surface absorbs light until the body shows them.
/// As in an Appearance, a colour is the share of the light that entered a thick body in even light
/// and leaves again. It is at most colorOf() the body's medium. Colours of vertices multiply it.
struct Paint {
  static constexpr float mostColor = 100;  ///< above 1 to brighten a dark texture

  std::string name;
  Rgb color{1, 1, 1};                   ///< in [0, mostColor]
  std::optional<Texture> colorTexture;  ///< rgb: sRGB, multiplies the color

  bool operator==(const Paint&) const = default;
};

/// How rough and uneven the surface of a translucent body is. Both shape its reflections; normals
/// also affect the light that enters. A texture multiplies the number beside it.
struct TranslucentSurface {
  /// Of the reflection, in [0, 1]; none: RenderOptions::roughness, or 1 if there is a texture.
  std::optional<float> roughness;
  std::optional<Texture> metallicRoughnessTexture;  ///< g: roughness, linear; the rest is not read
  std::optional<Texture> normalTexture;             ///< tangent space, green up, linear
  float normalScale = 1;                            ///< factor of the texture's x and y

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
