// Opaque surfaces' reflection of light from everywhere, by tables. Needs, before it, BINDING_GLOSS.
#ifndef OPALINE_LIB_GLOSS
#define OPALINE_LIB_GLOSS
#include "shared/opaque.h"

// What a lobe mirrors of even light by Schlick's term: x times F₀ and y times F₉₀.
layout(std430, set = 0, binding = BINDING_GLOSS) readonly buffer Gloss { vec2 gloss[]; };

// Beyond the last entries, half a step before 1, the table goes on straight.
vec2 glossOf(uint row, float cosine) {
  float place = max(cosine * float(glossEntries) - 0.5, 0.0);
  uint lower = min(uint(place), glossEntries - 2u);
  uint first = row * glossEntries + lower;
  return mix(gloss[first], gloss[first + 1u], place - float(lower));
}

// A straight line may go below 0 where little is mirrored.
vec2 glossOf(SeenMaterial material, float cosine) {
  float place = max(sqrt(material.diffuse.w) * float(glossEntries) - 0.5, 0.0);
  uint lower = min(uint(place), glossEntries - 2u);
  return max(mix(glossOf(lower, cosine), glossOf(lower + 1u, cosine), place - float(lower)), 0.0);
}

// What a rough surface mirrors over what its facets mirror once, because they send light on to each
// other (Turquin 2019). By this, white metal mirrors all light.
vec3 sentOn(vec3 headOn, vec2 parts) {
  return 1.0 + headOn * (1.0 / max(parts.x + parts.y, 1e-3) - 1.0);
}

vec3 mirroredBy(vec3 headOn, float grazing, vec2 parts) {
  return sentOn(headOn, parts) * (headOn * parts.x + grazing * parts.y);
}

// What the part that is no metal mirrors of even light that falls on it. Diffuse light has less of all channels, by as
// much as the strongest of these (KHR_materials_specular).
vec3 mirroredByDielectric(SeenMaterial material, vec2 parts) {
  return mirroredBy(material.dielectric.rgb, material.dielectric.w, parts);
}

// What both parts mirror of even light.
vec3 mirroredOf(SeenMaterial material, vec2 parts) {
  return mix(mirroredByDielectric(material, parts), mirroredBy(material.metal.rgb, 1.0, parts), material.metal.w);
}

// Schlick 1994, including what facets send on to each other.
vec3 facetReflectance(SeenMaterial material, vec2 parts, float cosine) {
  float grazing = pow(clamp(1.0 - cosine, 0.0, 1.0), 5.0);
  return mix(sentOn(material.dielectric.rgb, parts) * mix(material.dielectric.rgb, vec3(material.dielectric.w), grazing),
             sentOn(material.metal.rgb, parts) * mix(material.metal.rgb, vec3(1.0), grazing), material.metal.w);
}

#endif
