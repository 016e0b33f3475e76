// Light that arrives from the frame's lights. Needs lib/frame.glsl.
#ifndef OPALINE_LIB_LIGHT
#define OPALINE_LIB_LIGHT
#include "lib/fresnel.glsl"
#include "shared/medium.h"

// One light at one place, if nothing is in between.
struct IncidentLight {
  uint light;  // its index
  uint kind;
  vec3 direction;   // unit, towards the light
  vec3 irradiance;  // of a surface that faces it
};

// How many lights with a shadow map shine at a place: all, but none at infinity. Where uniforms alone say when a
// loop ends, Mesa's software device (22.3) compiles the shader anew for every dispatch and keeps every version.
uint lightsAt(vec3 position) {
  return isinf(position.x) ? 0u : frame.counts.x;
}

// The same, including area lights (lib/area_light.glsl), which come last.
uint allLightsAt(vec3 position) {
  return isinf(position.x) ? 0u : frame.counts.w;
}

uint firstAreaLight() {
  return frame.counts.x;
}

IncidentLight incidentLight(uint index, vec3 position) {
  LightData light = frame.lights[index];
  vec3 towards = light.place.xyz;
  if (light.kind.x == directionalLight)
    return IncidentLight(index, light.kind.x, towards, light.power.rgb);
  vec3 offset = towards - position;
  float squared = max(dot(offset, offset), 1e-12);
  vec3 direction = offset * inversesqrt(squared);
  float part = clamp(light.cone.x * -dot(direction, light.axis.xyz) + light.cone.y, 0.0, 1.0);
  return IncidentLight(index, light.kind.x, direction, light.power.rgb / squared * (part * part));
}

// The part of a light's irradiance that enters where it is visible. `outside` is the unit normal of the
// surface as it is drawn. What faces away from a light by that is in its own shadow, wherever `normal` looks.
float enteringPart(IncidentLight light, vec3 normal, vec3 outside, MediumData medium) {
  float cosine = dot(normal, light.direction);
  if (cosine <= 0.0 || dot(outside, light.direction) <= 0.0) return 0.0;
  return cosine * (1.0 - fresnelReflectance(medium.boundary.x, cosine));
}

// Whether a light of that kind has a shadow map of parallel rays. Otherwise it has the six views of a
// cube around it, or one of its cone or of the box around the scene.
bool isParallel(uint kind) {
  return kind == directionalLight;
}

// How far away from a place a light is, mm.
float distanceOf(IncidentLight light, vec3 position) {
  return isParallel(light.kind) ? 3e38 : distance(frame.lights[light.light].place.xyz, position);
}

bool hasOneView(LightData light) {
  return light.view.w != 0.0;
}

#endif
