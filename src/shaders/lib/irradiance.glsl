// Irradiance that enters (Eq. 7 and 9). Needs, before it, SHADOW_BINDING and AMBIENT_BINDING.
#ifndef OPALINE_LIB_IRRADIANCE
#define OPALINE_LIB_IRRADIANCE
#include "lib/frame.glsl"
#include "lib/shadow.glsl"
#include "lib/fresnel.glsl"
#include "lib/unit.glsl"
#include "shared/medium.h"

layout(set = 0, binding = AMBIENT_BINDING) uniform samplerCubeArray ambientIrradiance;

// `facet` is at right angles to the surface as it is drawn, of any length and either side: what of it
// faces away from a light is in its own shadow, wherever `normal` looks.
vec3 irradianceAt(vec3 position, vec3 normal, vec3 facet, MediumData medium) {
  vec3 outside = unitOr(dot(facet, normal) < 0.0 ? -facet : facet, normal);
  vec3 sum = textureLod(ambientIrradiance, vec4(normal, float(medium.tables.x)), 0.0).rgb;
  for (uint i = 0u; i < frame.counts.x; ++i) {
    vec3 toLight;
    vec3 arriving = lightIrradiance(i, position, toLight);
    float cosine = dot(normal, toLight);
    if (cosine <= 0.0 || dot(outside, toLight) <= 0.0) continue;
    float entering = cosine * (1.0 - fresnelReflectance(medium.boundary.x, cosine));
    sum += arriving * (entering * lightVisibility(i, position, outside));
  }
  return sum;
}

#endif
