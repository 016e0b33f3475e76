// Irradiance that enters (Eq. 7 and 9). Needs, before it, SHADOW_BINDING and AMBIENT_BINDING.
#ifndef OPALINE_LIB_IRRADIANCE
#define OPALINE_LIB_IRRADIANCE
#include "lib/frame.glsl"
#include "lib/shadow.glsl"
#include "lib/fresnel.glsl"
#include "shared/medium.h"

layout(set = 0, binding = AMBIENT_BINDING) uniform samplerCubeArray ambientIrradiance;

vec3 irradianceAt(vec3 position, vec3 normal, MediumData medium) {
  vec3 sum = textureLod(ambientIrradiance, vec4(normal, float(medium.tables.x)), 0.0).rgb;
  for (uint i = 0u; i < frame.counts.x; ++i) {
    vec3 toLight;
    vec3 arriving = lightIrradiance(i, position, toLight);
    float cosine = dot(normal, toLight);
    if (cosine <= 0.0) continue;
    float entering = cosine * (1.0 - fresnelReflectance(medium.boundary.x, cosine));
    sum += arriving * (entering * lightVisibility(i, position, normal));
  }
  return sum;
}

#endif
