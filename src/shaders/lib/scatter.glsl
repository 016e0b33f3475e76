// The sums of sources (Eq. 8). Needs, before it, BINDING_OBJECTS, BINDING_MEDIA, BINDING_PATTERN,
// BINDING_POSITION, BINDING_FLUX (pattern) or BINDING_SOURCES (all).
#ifndef OPALINE_LIB_SCATTER
#define OPALINE_LIB_SCATTER
#include "shared/frame.h"
#include "shared/medium.h"
#include "lib/profile.glsl"

layout(constant_id = 0) const uint transport = 0u;  // 0: dipole, 1: better dipole

layout(std430, set = 0, binding = BINDING_OBJECTS) readonly buffer Objects { ObjectData objects[]; };
layout(std430, set = 0, binding = BINDING_MEDIA) readonly buffer Media { MediumData media[]; };

// Of a distance for each channel, squared.
vec3 reflectanceProfile(Profile profile, vec3 squaredMm2) {
  return transport == 0u ? dipoleProfile(profile, squaredMm2)
                         : betterDipoleProfile(profile, squaredMm2);
}

#ifdef BINDING_PATTERN
layout(std140, set = 0, binding = BINDING_PATTERN) uniform Pattern {
  PatternEntry pattern[maxPatternEntries];
};
layout(set = 0, binding = BINDING_POSITION) uniform sampler2D nearPosition;  // mm; 1 on surface
layout(set = 0, binding = BINDING_FLUX) uniform sampler2D nearFlux;          // E·A; A

// The near block around a place among the neighbourhoods (Gong et al. 2008, section 4.1), each
// sample weighted by the texels it stands for (section 4.2). The cell at the centre, where the
// profile is sharpest, is integrated rather than sampled. To the square of a sample's distance comes
// that of the extent of the piece of surface it stands for: one that comes close in space, where the
// surface folds, must not outshine it. The pattern is that of the medium, the same for all
// invocations.
vec3 nearSum(vec3 position, MediumData medium, vec2 place) {
  ivec2 centre = ivec2(place * vec2(textureSize(nearPosition, 0)));

  vec4 cell = pattern[0].value;
  vec4 flux = textureLod(nearFlux, place, 0.0);
  float present = textureLod(nearPosition, place, 0.0).a;
  float stretch = flux.a / (max(present, 1e-6) * cell.a);
  vec3 atCentre = flux.rgb / max(flux.a, 1e-20) * cell.rgb *
                  pow(vec3(stretch), pattern[1].value.rgb);

  vec3 sum = vec3(0.0);
  uint end = 2u + medium.tables.y;
  for (uint i = 2u; i < end; ++i) {
    vec4 entry = pattern[i].value;
    int packed = floatBitsToInt(entry.a);
    ivec2 texel = centre + ivec2(bitfieldExtract(packed, 0, 16), packed >> 16);
    vec3 offset = texelFetch(nearPosition, texel, 0).xyz - position;
    sum += texelFetch(nearFlux, texel, 0).rgb *
           reflectanceProfile(medium.profile, dot(offset, offset) * entry.rgb + medium.boundary.z);
  }
  return atCentre + sum * pattern[1].value.a;
}
#endif

#ifdef BINDING_SOURCES
layout(std430, set = 0, binding = BINDING_SOURCES) readonly buffer Sources { vec4 sources[]; };

// Sources first .. last - 1, of those that belong to the object.
vec3 sourceSum(vec3 position, uint object, uint first, uint last) {
  ObjectData body = objects[object];
  Profile profile = media[body.table.x].profile;
  first = max(first, body.table.y);
  last = min(last, body.table.y + body.table.z);
  vec3 sum = vec3(0.0);
  for (uint i = first; i < last; ++i) {
    vec3 offset = sources[2u * i].xyz - position;
    sum += sources[2u * i + 1u].rgb * reflectanceProfile(profile, vec3(dot(offset, offset)));
  }
  return sum;
}
#endif

#endif
