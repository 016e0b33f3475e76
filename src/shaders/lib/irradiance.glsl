// Irradiance that enters (Eq. 7 and 9). Needs, before it, SHADOW_BINDING and, for the sky's,
// BINDING_SKY_IRRADIANCE. With THROUGH_BINDING it counts light through bodies, and needs what lib/light_through.glsl needs.
#ifndef OPALINE_LIB_IRRADIANCE
#define OPALINE_LIB_IRRADIANCE
#include "lib/frame.glsl"
#include "lib/shadow.glsl"
#include "lib/sky.glsl"
#include "lib/unit.glsl"
#ifdef THROUGH_BINDING
#include "lib/light_through.glsl"
#endif

vec3 arrivingOf(IncidentLight light, vec3 position, vec3 outside) {
  float visible = visibilityOf(light, position, outside);
#ifdef THROUGH_BINDING
  float away = distanceOf(light, position);
  return arrivingPart(visible, position, outside, light.direction, away, filteredOver(light, away));
#else
  return vec3(visible);
#endif
}

// From lights with shadow maps.
vec3 lightsIrradiance(vec3 position, vec3 normal, vec3 outside, MediumData medium) {
  vec3 sum = vec3(0.0);
  for (uint i = 0u; i < lightsAt(position); ++i) {
    IncidentLight light = incidentLight(i, position);
    float part = enteringPart(light, normal, outside, medium);
    if (part > 0.0) sum += light.irradiance * (part * arrivingOf(light, position, outside));
  }
  return sum;
}

// The unit normal of the surface as it is drawn, on the side of `normal`. `facet` is at right angles
// to it, of any length and either side.
vec3 outsideOf(vec3 facet, vec3 normal) {
  return unitOr(dot(facet, normal) < 0.0 ? -facet : facet, normal);
}

#ifdef BINDING_SKY_IRRADIANCE
// From these and the sky.
vec3 irradianceAt(vec3 position, vec3 normal, vec3 facet, MediumData medium) {
  vec3 outside = outsideOf(facet, normal);
  return skyIrradianceAt(normal, medium) + lightsIrradiance(position, normal, outside, medium);
}
#endif

#endif
