// Rays that find how much of what surfaces mirror is sky. Included by C++ and GLSL.
#ifndef OPALINE_SHARED_SKY_RAYS_H
#define OPALINE_SHARED_SKY_RAYS_H

#ifdef __cplusplus
#include <algorithm>
#include <cmath>
namespace opaline::shared {
#define OPALINE_SKY_RAYS_INLINE inline
#else
#define OPALINE_SKY_RAYS_INLINE
#endif

/// Rays per sample. A mirror needs one, as antialiasing softens its edges; a wide lobe needs a few.
OPALINE_SKY_RAYS_INLINE float skyRaysOfSample(float alpha) {
#ifdef __cplusplus
  using std::clamp;
  using std::floor;
#endif
  float raysOfAlpha = 16.0f;
  return clamp(floor(raysOfAlpha * alpha + 0.5f), 1.0f, 8.0f);
}

#ifdef __cplusplus
}  // namespace opaline::shared
#endif

#endif
