// Opaque materials and their textures in storage buffers. Included by C++ and GLSL.
#ifndef OPALINE_SHARED_OPAQUE_H
#define OPALINE_SHARED_OPAQUE_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/vec4.hpp>
namespace opaline::shared {
using glm::uvec4;
using glm::vec4;
#define OPALINE_OPAQUE_CONSTANT constexpr std::uint32_t
#else
#define OPALINE_OPAQUE_CONSTANT const uint
#endif

/// Bits of TextureData::place.w: two for each direction's wrap, as in TextureWrap.
OPALINE_OPAQUE_CONSTANT wrapVShift = 2u;
OPALINE_OPAQUE_CONSTANT textureHasEdges = 16u;  // sharp between its texels, when magnified
OPALINE_OPAQUE_CONSTANT textureIsOnSecondSet = 32u;

/// Levels of the largest texture there may be, 16384 pixels along an edge.
OPALINE_OPAQUE_CONSTANT mostTextureLevels = 15u;

struct TextureData {
  uvec4 place;  // x: first texel of level 0, with the other levels behind it; y: width, height from
                // bit 16; z: levels, 0 without a texture; w: bits as above
  vec4 rowU;    // xyz: rows of the affine map from the mesh's coordinates
  vec4 rowV;
};

/// A material as the library's material.h has it.
struct OpaqueData {
  vec4 baseColor;  // rgb; w: alpha
  vec4 emission;   // rgb; w: alpha cutoff
  vec4 surface;    // x: metallic; y: roughness, or below 0 the picture's; z: F₀ of the index of
                   // refraction; w: specular
  vec4 specularColor;  // rgb; w: scale of the normal texture
  vec4 rest;           // x: occlusion strength; y: 1 where it is unlit; z: 1 where vertices have
                       // attributes
  vec4 through;        // rgb: color of diffuse transmission; w: its share
  TextureData baseColorTexture;
  TextureData metallicRoughnessTexture;
  TextureData specularTexture;
  TextureData specularColorTexture;
  TextureData normalTexture;
  TextureData occlusionTexture;
  TextureData emissionTexture;
  TextureData throughTexture;
  TextureData throughColorTexture;
};

/// What textures and colours need of a vertex.
struct VertexAttributes {
  vec4 coordinates;  // two sets
  vec4 color;
};

/// Tangents of a triangle's corners, as parts of its edges from the first corner to the second and
/// to the third, so that they follow the deformation.
struct CornerTangents {
  vec4 first;  // of corner 0, xy, and 1, zw
  vec4 last;   // of corner 2, xy; z: side of the bitangent
};

/// What an opaque surface is made of where a pixel sees it. Of translucent ones only roughness,
/// normal, `around` and `behind` are set.
struct SeenMaterial {
  vec4 diffuse;  // rgb: share of light given back diffusely, less what is mirrored; w: roughness²
  vec4 dielectric;  // rgb: F₀ of the part that is no metal; w: its F₉₀
  vec4 metal;       // rgb: F₀ of metal; w: share that is metal
  vec4 normal;      // unit, to the side that is seen; w: share of indirect light
  vec4 emission;    // rgb: radiance; w: 1 where it is unlit
  vec4 around;   // rgb: mean radiance of what the lobe mirrors of the scene; w: share of it that is
                 // sky. For a translucent surface, rgb leaves out the sky; w: 1 where it is known
  vec4 through;  // rgb: share of light on the other side that leaves here diffusely, less what is
                 // mirrored
  vec4 behind;   // rgb: irradiance on the other side, where some of it gets through. For a
                 // translucent surface, radiance seen through it, before its boundary mirrors some
};

/// Roughnesses of the tables of what translucent surfaces mirror: (i + ½) over this many.
OPALINE_OPAQUE_CONSTANT albedoRows = 16u;

/// The most rays for what an opaque surface mirrors.
OPALINE_OPAQUE_CONSTANT mostMirroredRays = 16u;

/// Entries along roughness and along the view's cosine of the tables of reflection, without
/// Fresnel's reflectance and with that of Schlick 1994.
OPALINE_OPAQUE_CONSTANT glossEntries = 32u;

/// Roughnesses in the tables of their lobes (lights/reflection_lobe.h), which have as many cosines.
OPALINE_OPAQUE_CONSTANT glossLobeRows = 8u;

/// Levels of the sky as surfaces of roughness 0 to 1 mirror it.
OPALINE_OPAQUE_CONSTANT glossySkyLevels = 6u;

#ifdef __cplusplus
}  // namespace opaline::shared
#endif

#endif
