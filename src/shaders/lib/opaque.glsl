// Opaque surfaces. Needs, before it, what lib/material.glsl and lib/shadow.glsl need.
#ifndef OPALINE_LIB_OPAQUE
#define OPALINE_LIB_OPAQUE
#include "lib/material.glsl"
#include "lib/shadow.glsl"

// The exitance by lights with shadow maps. `outside` is the unit normal of the surface as it is drawn.
vec3 givenBack(vec3 position, vec3 normal, vec3 outside, ObjectData body) {
  MediumData material = mediumAt(body, position);
  vec3 sum = vec3(0.0);
  for (uint i = 0u; i < lightsAt(position); ++i) {
    IncidentLight light = incidentLight(i, position);
    float part = enteringPart(light, normal, outside, material);
    if (part > 0.0) sum += light.irradiance * (part * visibilityOf(light, position, outside));
  }
  return material.opaque.rgb * sum;
}

#endif
