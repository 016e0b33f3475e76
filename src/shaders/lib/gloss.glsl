// Opaque surfaces' reflection of light from everywhere, by tables. Needs, before it, BINDING_GLOSS.
#ifndef OPALINE_LIB_GLOSS
#define OPALINE_LIB_GLOSS
#include "shared/opaque.h"

// Of even light, x: what a lobe mirrors of it less what Schlick's term takes off F₀, and y: what that
// adds to F₉₀.
layout(std430, set = 0, binding = BINDING_GLOSS) readonly buffer Gloss { vec2 gloss[]; };

vec2 glossOf(uint row, float cosine) {
  float place = clamp(cosine * float(glossEntries) - 0.5, 0.0, float(glossEntries) - 1.001);
  uint lower = row * glossEntries + uint(place);
  return mix(gloss[lower], gloss[lower + 1u], fract(place));
}

vec2 glossOf(SeenMaterial material, float cosine) {
  float place = clamp(sqrt(material.diffuse.w) * float(glossEntries) - 0.5, 0.0, float(glossEntries) - 1.001);
  return mix(glossOf(uint(place), cosine), glossOf(uint(place) + 1u, cosine), fract(place));
}

// What a rough surface's facets send on to each other, over what they mirror once (Turquin 2019), so
// that white metal mirrors all light.
vec3 sentOn(SeenMaterial material, vec2 parts) {
  return 1.0 + material.specular.rgb * (1.0 / max(parts.x + parts.y, 1e-3) - 1.0);
}

// What is mirrored of even light once.
vec3 mirroredOnce(SeenMaterial material, vec2 parts) {
  return material.specular.rgb * parts.x + material.specular.w * parts.y;
}

#endif
