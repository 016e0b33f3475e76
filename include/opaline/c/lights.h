#pragma once

/// Lights in C; part of opaline/opaline_c.h.

#include "opaline/c/scenes.h"
#include "opaline/c/status.h"

OPALINE_C_BEGIN

// At most 16 in all; see opaline/scene.h. Radiance, irradiance and intensity are linear RGB, in
// [0, 1e30]; directions have unit length.

/// Removes all lights, ambient light and environment.
OPALINE_API OpalineStatus opalineClearLights(OpalineScene* scene);

/// Replaces all lights by a key light from behind at the side, a weak fill and weak ambient light.
OPALINE_API OpalineStatus opalineUseDefaultLights(OpalineScene* scene);

/// Lights without size. A spot has full intensity within the inner angle from its axis and none
/// beyond the outer one.
OPALINE_API OpalineStatus opalineAddDirectionalLight(OpalineScene* scene,
                                                     const float directionToLight[3],
                                                     const float irradiance[3]);
OPALINE_API OpalineStatus opalineAddPointLight(OpalineScene* scene, const float positionMm[3],
                                               const float intensity[3]);
OPALINE_API OpalineStatus opalineAddSpotLight(OpalineScene* scene, const float positionMm[3],
                                              const float direction[3], const float intensity[3],
                                              float innerDegrees, float outerDegrees);
/// A directional light that surfaces mirror as a disc, of an angular radius in [0, 10]; the sun's
/// is 0.27.
OPALINE_API OpalineStatus opalineAddSun(OpalineScene* scene, const float directionToLight[3],
                                        const float irradiance[3], float angularRadiusDegrees);
/// A parallelogram; u and v are half its edges, and it shines to the side of u × v.
OPALINE_API OpalineStatus opalineAddRectangleLight(OpalineScene* scene, const float centreMm[3],
                                                   const float uMm[3], const float vMm[3],
                                                   const float radiance[3]);
OPALINE_API OpalineStatus opalineAddDiscLight(OpalineScene* scene, const float centreMm[3],
                                              const float normal[3], float radiusMm,
                                              const float radiance[3]);
OPALINE_API OpalineStatus opalineAddSphereLight(OpalineScene* scene, const float centreMm[3],
                                                float radiusMm, const float radiance[3]);
OPALINE_API OpalineStatus opalineAddTubeLight(OpalineScene* scene, const float fromMm[3],
                                              const float toMm[3], float radiusMm,
                                              const float radiance[3]);
/// Sets whether an area light also shines to the other side, as rectangles and discs can, and
/// whether the picture itself shows it: 1 or 0. `light` counts area lights from 0 as they were
/// added.
OPALINE_API OpalineStatus opalineSetAreaLight(OpalineScene* scene, size_t light, int32_t twoSided,
                                              int32_t visible);
/// Light of the same radiance from all directions.
OPALINE_API OpalineStatus opalineSetAmbientLight(OpalineScene* scene, const float radiance[3]);
/// A latitude-longitude picture, .exr or .hdr, whose radiance is multiplied by `intensity`, turned
/// about +y.
OPALINE_API OpalineStatus opalineSetEnvironment(OpalineScene* scene, const char* file,
                                                float intensity, double rotationDegrees);
/// The same from memory: 4 · width · height floats, which are copied. They are linear R G B and one
/// that is not read.
OPALINE_API OpalineStatus opalineSetEnvironmentPixels(OpalineScene* scene, const float* rgba,
                                                      int32_t width, int32_t height,
                                                      float intensity, double rotationDegrees);

OPALINE_C_END
