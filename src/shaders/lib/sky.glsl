// The sky: all light that comes from everywhere. Needs, before it, BINDING_SKY_RADIANCE,
// BINDING_SKY_IRRADIANCE or BINDING_SKY_REFLECTION, for what is asked of it.
#ifndef OPALINE_LIB_SKY
#define OPALINE_LIB_SKY
#include "shared/medium.h"

#ifdef BINDING_SKY_RADIANCE
layout(set = 0, binding = BINDING_SKY_RADIANCE) uniform samplerCubeArray skyRadiance;

// The mean around a direction, over that solid angle.
vec3 skyRadianceFrom(vec3 direction, float solidAngle) {
  float edge = float(textureSize(skyRadiance, 0).x);
  float texel = 2.0943951 / (edge * edge);  // sr, a sixth of the sphere over a face's texels
  return textureLod(skyRadiance, vec4(direction, 0.0), max(0.5 * log2(solidAngle / texel), 0.0)).rgb;
}
#endif

#ifdef BINDING_SKY_IRRADIANCE
layout(set = 0, binding = BINDING_SKY_IRRADIANCE) uniform samplerCubeArray skyIrradiance;

// What enters where nothing is in the way (Gong et al. 2008, Eq. 9).
vec3 skyIrradianceAt(vec3 normal, MediumData medium) {
  return textureLod(skyIrradiance, vec4(normal, float(medium.tables.x)), 0.0).rgb;
}
#endif

#ifdef BINDING_SKY_REFLECTION
layout(set = 0, binding = BINDING_SKY_REFLECTION) uniform samplerCubeArray skyReflection;

// Radiance around a mirrored direction, as the surface's lobe sees it.
vec3 skyReflectedFrom(vec3 direction) {
  return textureLod(skyReflection, vec4(direction, 0.0), 0.0).rgb;
}
#endif

#endif
