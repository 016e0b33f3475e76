// Irradiance that enters (Eq. 7 and 9). Needs, before it, SHADOW_BINDING and AMBIENT_BINDING.
#ifndef OPALINE_LIB_IRRADIANCE
#define OPALINE_LIB_IRRADIANCE
#include "lib/frame.glsl"
#include "lib/shadow.glsl"
#include "lib/fresnel.glsl"
#include "lib/unit.glsl"
#include "shared/medium.h"

layout(set = 0, binding = AMBIENT_BINDING) uniform samplerCubeArray ambientIrradiance;

vec3 ambientAt(vec3 normal, MediumData medium) {
  return textureLod(ambientIrradiance, vec4(normal, float(medium.tables.x)), 0.0).rgb;
}

// The part of a light's irradiance that enters where it is visible. `outside` is the unit normal of
// the surface as it is drawn: what of it faces away from a light is in its own shadow, wherever
// `normal` looks.
float enteringPart(IncidentLight light, vec3 normal, vec3 outside, MediumData medium) {
  float cosine = dot(normal, light.direction);
  if (cosine <= 0.0 || dot(outside, light.direction) <= 0.0) return 0.0;
  return cosine * (1.0 - fresnelReflectance(medium.boundary.x, cosine));
}

// Of one light.
vec3 irradianceOf(uint index, vec3 position, vec3 normal, vec3 outside, MediumData medium) {
  IncidentLight light = incidentLight(index, position);
  float part = enteringPart(light, normal, outside, medium);
  if (part == 0.0) return vec3(0.0);
  return light.irradiance * (part * visibilityOf(light, position, outside));
}

// Of all lights.
vec3 lightsIrradiance(vec3 position, vec3 normal, vec3 outside, MediumData medium) {
  vec3 sum = vec3(0.0);
  for (uint i = 0u; i < frame.counts.x; ++i)
    sum += irradianceOf(i, position, normal, outside, medium);
  return sum;
}

// Of all. `facet` is at right angles to the surface as it is drawn, of any length and either side.
vec3 irradianceAt(vec3 position, vec3 normal, vec3 facet, MediumData medium) {
  vec3 outside = unitOr(dot(facet, normal) < 0.0 ? -facet : facet, normal);
  return ambientAt(normal, medium) + lightsIrradiance(position, normal, outside, medium);
}

#endif
