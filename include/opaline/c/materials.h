#pragma once

/// Paint, surfaces and opaque materials of objects in C; part of opaline/opaline_c.h.
/// opaline/material.h explains the numbers, which have the same names there.

#include "opaline/c/scenes.h"
#include "opaline/c/status.h"

OPALINE_C_BEGIN

/// The pixels of textures, in the host's memory.
typedef struct OpalinePixels OpalinePixels;

/// Copies pixels R G B A, rows from top to bottom, as a picture file stores them: colours in sRGB,
/// all else linear. `bitsPerChannel` is 8 or 16.
OPALINE_API OpalineStatus opalineCreatePixels(const void* rgba, int32_t bitsPerChannel,
                                              int32_t width, int32_t height,
                                              OpalinePixels** pixels);
/// Textures of scenes keep the pixels that they use.
OPALINE_API void opalineDestroyPixels(OpalinePixels* pixels);

/// How a texture continues outside of [0, 1].
typedef enum OpalineWrap {
  OpalineWrapRepeat = 0,
  OpalineWrapMirroredRepeat = 1,
  OpalineWrapClampToEdge = 2
} OpalineWrap;

/// A picture that varies a number of a material over the surface; it multiplies the number.
typedef struct OpalineTexture {
  size_t size;  ///< sizeof(OpalineTexture)
  const OpalinePixels* pixels;
  OpalineWrap wrapU;
  OpalineWrap wrapV;
  int32_t interpolated;  ///< 1 or 0
  int32_t coordinates;   ///< which of the object's two sets, 0 or 1
  float transform[6];    ///< rows of an affine map from these to the picture
} OpalineTexture;

/// Fills a struct whose size has been set, except for its pixels.
OPALINE_API OpalineStatus opalineDefaultTexture(OpalineTexture* texture);

/// Texture coordinates of an object's vertices, two floats each. `set` is 0 or 1. `strideBytes` is
/// the distance from one vertex to the next; 0: 8.
OPALINE_API OpalineStatus opalineSetObjectTextureCoordinates(OpalineScene* scene, size_t object,
                                                             int32_t set, const float* coordinates,
                                                             size_t vertexCount,
                                                             size_t strideBytes);

/// Colours of an object's vertices, four floats each, linear R G B and alpha. They multiply the
/// colour of paint or of an opaque material. `strideBytes` as above; 0: 16.
OPALINE_API OpalineStatus opalineSetObjectColors(OpalineScene* scene, size_t object,
                                                 const float* rgba, size_t vertexCount,
                                                 size_t strideBytes);

/// Colours on a translucent body; see Paint.
typedef struct OpalinePaint {
  size_t size;                         ///< sizeof(OpalinePaint)
  float color[3];                      ///< in [0, 100]
  const OpalineTexture* colorTexture;  ///< may be NULL
} OpalinePaint;

/// NULL removes the paint.
OPALINE_API OpalineStatus opalineSetObjectPaint(OpalineScene* scene, size_t object,
                                                const OpalinePaint* paint);

/// How rough and uneven the surface of a translucent body is; see TranslucentSurface.
typedef struct OpalineSurface {
  size_t size;             ///< sizeof(OpalineSurface)
  const float* roughness;  ///< in [0, 1]; NULL: that of OpalineRenderOptions, or 1 with a texture
  const OpalineTexture* metallicRoughnessTexture;  ///< may be NULL
  const OpalineTexture* normalTexture;             ///< may be NULL
  float normalScale;
} OpalineSurface;

/// Fills a struct whose size has been set.
OPALINE_API OpalineStatus opalineDefaultSurface(OpalineSurface* surface);

/// NULL: the mesh's normals and the roughness of OpalineRenderOptions.
OPALINE_API OpalineStatus opalineSetObjectSurface(OpalineScene* scene, size_t object,
                                                  const OpalineSurface* surface);

/// A surface without an inside; see OpaqueMaterial. Textures may be NULL.
typedef struct OpalineOpaqueMaterial {
  size_t size;  ///< sizeof(OpalineOpaqueMaterial)
  float baseColor[3];
  float metallic;
  float roughness;
  float ior;
  float specular;
  float specularColor[3];
  float normalScale;
  float occlusionStrength;
  float emission[3];
  float alphaCutoff;
  float alpha;
  int32_t unlit;  ///< 1 or 0
  const OpalineTexture* baseColorTexture;
  const OpalineTexture* metallicRoughnessTexture;
  const OpalineTexture* specularTexture;
  const OpalineTexture* specularColorTexture;
  const OpalineTexture* normalTexture;
  const OpalineTexture* occlusionTexture;
  const OpalineTexture* emissionTexture;
  float diffuseTransmission;
  float diffuseTransmissionColor[3];
  const OpalineTexture* diffuseTransmissionTexture;
  const OpalineTexture* diffuseTransmissionColorTexture;
} OpalineOpaqueMaterial;

/// Fills a struct whose size has been set.
OPALINE_API OpalineStatus opalineDefaultOpaqueMaterial(OpalineOpaqueMaterial* material);

/// NULL makes the object translucent again, with the medium that it has.
OPALINE_API OpalineStatus opalineSetObjectOpaque(OpalineScene* scene, size_t object,
                                                 const OpalineOpaqueMaterial* material);

OPALINE_C_END
