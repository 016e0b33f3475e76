#pragma once

/// Pictures and comparisons in C; part of opaline/opaline_c.h.

#include "opaline/c/scenes.h"
#include "opaline/c/status.h"

OPALINE_C_BEGIN

/// How radiance becomes colour.
typedef struct OpalineTone {
  size_t size;              ///< sizeof(OpalineTone)
  float exposureStops;      ///< in [-32, 32]
  int32_t neutral;          ///< 1: Khronos PBR Neutral; 0: clip at 1
  const float* background;  ///< three floats, linear; NULL: alpha is coverage
} OpalineTone;

/// Fills a struct whose size has been set.
OPALINE_API OpalineStatus opalineDefaultTone(OpalineTone* tone);

/// The exposure that suits a scene's light, in stops.
OPALINE_API OpalineStatus opalineAutomaticExposure(const OpalineScene* scene, float* stops);

/// Write 4 · width · height floats, as opalineRender() returns them. `tone` may be NULL.
OPALINE_API OpalineStatus opalineWritePng(const char* file, const float* rgba, int32_t width,
                                          int32_t height, const OpalineTone* tone);
OPALINE_API OpalineStatus opalineWriteExr(const char* file, const float* rgba, int32_t width,
                                          int32_t height);

/// An .exr or .hdr file.
typedef struct OpalineImage OpalineImage;
OPALINE_API OpalineStatus opalineReadImage(const char* file, OpalineImage** image);
OPALINE_API void opalineDestroyImage(OpalineImage* image);
OPALINE_API int32_t opalineImageWidth(const OpalineImage* image);
OPALINE_API int32_t opalineImageHeight(const OpalineImage* image);
/// 4 · width · height floats that live as long as the image.
OPALINE_API const float* opalineImagePixels(const OpalineImage* image);

/// How far image A is from B, over the pixels that both cover. Relative errors are divided by the
/// mean of |B|.
typedef struct OpalineDifference {
  size_t size;  ///< sizeof(OpalineDifference)
  uint64_t coveredPixels;
  double relRmse;
  double relBias;  ///< mean of A - B
  double p95Rel;   ///< 95th percentile of |A - B|
  double maxAbs;
  double psnrDb;
} OpalineDifference;

/// Each image has 4 · width · height floats.
OPALINE_API OpalineStatus opalineCompare(const float* rgbaOfA, const float* rgbaOfB, int32_t width,
                                         int32_t height, OpalineDifference* difference);

OPALINE_C_END
