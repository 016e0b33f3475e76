// Sources, summed one by one. Needs, before it, BINDING_SOURCES and what lib/scatter.glsl needs.
#ifndef OPALINE_LIB_SURFEL_SUM
#define OPALINE_LIB_SURFEL_SUM
#include "lib/scatter.glsl"
#include "lib/texels.glsl"
#include "shared/surfels.h"

TEXELS(BINDING_SOURCES, sources);  // Source

vec4 positionAreaOf(uint source) {
  return texelOf(sources, 2 * int(source));
}

vec3 fluxOf(uint source) {
  return texelOf(sources, 2 * int(source) + 1).rgb;
}

// The same bits in every shader, so that each source is on one side of the reach.
float squaredDistanceTo(vec3 place, vec3 position) {
  precise vec3 offset = place - position;
  precise float squared = dot(offset, offset);
  return squared;
}

// The sum over surfels first .. end - 1 of sources that lie no nearer than the reach, mm;
// lib/nearby.glsl has the others. The fourth component counts evaluations of the profile.
vec4 surfelSum(vec3 position, Profile profile, float reach, uint first, uint end) {
  vec4 sum = vec4(0.0);
  for (uint i = sourcesPerSurfel * first; i < sourcesPerSurfel * end; ++i) {
    float squared = squaredDistanceTo(positionAreaOf(i).xyz, position);
    if (squared < reach * reach) continue;
    sum += vec4(fluxOf(i) * reflectanceProfile(profile, vec3(squared)), 1.0);
  }
  return sum;
}

// The same for surfels that belong to the object.
vec4 surfelSumOf(vec3 position, ObjectData body, uint first, uint end) {
  first = max(first, body.table.y);
  end = min(end, body.table.y + body.table.z);
  if (first >= end) return vec4(0.0);
  return surfelSum(position, mediumAt(body, position).profile, body.darkest.w, first, end);
}

#endif
