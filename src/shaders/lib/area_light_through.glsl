// The same as lib/light_through.glsl for area lights. Needs lib/area_shadow.glsl as well.
#ifndef OPALINE_LIB_AREA_LIGHT_THROUGH
#define OPALINE_LIB_AREA_LIGHT_THROUGH
#include "lib/area_shadow.glsl"
#include "lib/light_through.glsl"

// Where a part of a light is hidden, that is on its edge first or last, so most places are there.
const uint placesOfEdge = 8u;
// Enough where all of it is hidden.
const uint placesWithin = 4u;

vec2 placeThrough(AreaView view, uint k, bool all) {
  if (all) return netPlace(k);
  return k == placesOfEdge ? netPlace(0u) : edgePlace(view, float(k) / float(placesOfEdge));
}

// The part of an area light that arrives: what is visible, and of the rest what gets through on the mean of rays that
// meet something.
vec3 arrivingPartOfArea(float visible, AreaView view, Receiver to) {
  if (!looksThrough(visible)) return vec3(visible);
  vec4 sum = vec4(0.0);
  bool all = visible == 0.0;
  uint places = all ? placesWithin : placesOfEdge + 1u;
  for (uint k = 0u; k < places; ++k) {
    AreaSample place = sampleOf(view, placeThrough(view, k, all));
    float away = length(place.offset);
    float weight = place.weight * dot(place.offset, to.normal) / max(away, 1e-15);
    if (weight <= 0.0 || dot(place.offset, to.outside) <= 0.0) continue;
    vec4 through = throughFrom(to.position, to.outside, place.offset / away, away);
    sum += weight * through.w * vec4(through.rgb, 1.0);
  }
  return visible + (1.0 - visible) * sum.rgb / max(sum.w, 1e-30);
}

#endif
