// The sky as surfaces of any roughness mirror it.
#ifndef OPALINE_LIB_GLOSSY_SKY
#define OPALINE_LIB_GLOSSY_SKY
#include "shared/opaque.h"

vec3 glossySkyFrom(samplerCubeArray sky, vec3 direction, float alpha) {
  return textureLod(sky, vec4(direction, 0.0), sqrt(alpha) * float(glossySkyLevels - 1u)).rgb;
}

#endif
