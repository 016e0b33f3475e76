// Light that arrives from the frame's lights. Needs lib/frame.glsl.
#ifndef OPALINE_LIB_LIGHT
#define OPALINE_LIB_LIGHT
#include "lib/fresnel.glsl"
#include "shared/medium.h"

// Of one light at one place, wherever nothing is between.
struct IncidentLight {
  uint light;  // its index
  uint kind;
  vec3 direction;   // unit, towards the light
  vec3 irradiance;  // of a surface that faces it
};

// How many shine at a place: all, but none infinitely far away. Where uniforms alone tell a loop's end,
// Mesa's software device (22.3) compiles the shader anew for every dispatch, and keeps all of them.
uint lightsAt(vec3 position) {
  return isinf(position.x) ? 0u : frame.counts.x;
}

IncidentLight incidentLight(uint index, vec3 position) {
  LightData light = frame.lights[index];
  vec3 towards = light.place.xyz;
  if (light.kind.x == directionalLight)
    return IncidentLight(index, light.kind.x, towards, light.power.rgb);
  vec3 offset = towards - position;
  float squared = max(dot(offset, offset), 1e-12);
  return IncidentLight(index, light.kind.x, offset * inversesqrt(squared), light.power.rgb / squared);
}

// The part of a light's irradiance that enters where it is visible. `outside` is the unit normal of
// the surface as it is drawn: what of it faces away from a light is in its own shadow, wherever
// `normal` looks.
float enteringPart(IncidentLight light, vec3 normal, vec3 outside, MediumData medium) {
  float cosine = dot(normal, light.direction);
  if (cosine <= 0.0 || dot(outside, light.direction) <= 0.0) return 0.0;
  return cosine * (1.0 - fresnelReflectance(medium.boundary.x, cosine));
}

// Whether a light of that kind has a shadow map of parallel rays. Else it has the six views of a cube
// around it.
bool isParallel(uint kind) {
  return kind == directionalLight;
}

#endif
