// Light that comes from everywhere. Needs, before it, AMBIENT_BINDING.
#ifndef OPALINE_LIB_SKY
#define OPALINE_LIB_SKY
#include "shared/medium.h"

layout(set = 0, binding = AMBIENT_BINDING) uniform samplerCubeArray ambientIrradiance;

vec3 ambientAt(vec3 normal, MediumData medium) {
  return textureLod(ambientIrradiance, vec4(normal, float(medium.tables.x)), 0.0).rgb;
}

#endif
