// Sources, summed one by one. Needs, before it, BINDING_SOURCES and what lib/scatter.glsl needs.
#ifndef OPALINE_LIB_SURFEL_SUM
#define OPALINE_LIB_SURFEL_SUM
#include "lib/scatter.glsl"
#include "shared/surfels.h"

layout(set = 0, binding = BINDING_SOURCES) uniform samplerBuffer sources;  // Source

vec4 positionAreaOf(uint source) {
  return texelFetch(sources, 2 * int(source));
}

// Those of surfels first .. end - 1.
vec3 surfelSum(vec3 position, Profile profile, uint first, uint end) {
  vec3 sum = vec3(0.0);
  for (uint i = sourcesPerSurfel * first; i < sourcesPerSurfel * end; ++i) {
    vec3 offset = positionAreaOf(i).xyz - position;
    vec3 flux = texelFetch(sources, 2 * int(i) + 1).rgb;
    sum += flux * reflectanceProfile(profile, vec3(dot(offset, offset)));
  }
  return sum;
}

// The same of those that belong to the object. The fourth component counts evaluations of the
// profile.
vec4 surfelSumOf(vec3 position, ObjectData body, uint first, uint end) {
  first = max(first, body.table.y);
  end = min(end, body.table.y + body.table.z);
  if (first >= end) return vec4(0.0);
  return vec4(surfelSum(position, media[body.table.x].profile, first, end),
              float(sourcesPerSurfel * (end - first)));
}

#endif
