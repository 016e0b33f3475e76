// Opaque surfaces. Needs, before it, what lib/material.glsl and lib/irradiance.glsl need.
#ifndef OPALINE_LIB_OPAQUE
#define OPALINE_LIB_OPAQUE
#include "lib/irradiance.glsl"
#include "lib/material.glsl"

// The exitance by lights with shadow maps. `outside` is the unit normal of the surface as it is drawn.
vec3 givenBack(vec3 position, vec3 normal, vec3 outside, ObjectData body) {
  MediumData material = mediumAt(body, position);
  return material.opaque.rgb * lightsIrradiance(position, normal, outside, material);
}

#endif
