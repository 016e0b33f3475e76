// The sums of sources (Eq. 8). Needs, before it, BINDING_OBJECTS, BINDING_MEDIA, BINDING_PATTERN,
// BINDING_POSITION, BINDING_IRRADIANCE (pattern) or BINDING_SOURCES (all).
#ifndef OPALINE_LIB_SCATTER
#define OPALINE_LIB_SCATTER
#include "shared/frame.h"
#include "shared/medium.h"
#include "lib/profile.glsl"

layout(constant_id = 0) const uint transport = 0u;  // 0: dipole, 1: better dipole

layout(std430, set = 0, binding = BINDING_OBJECTS) readonly buffer Objects { ObjectData objects[]; };
layout(std430, set = 0, binding = BINDING_MEDIA) readonly buffer Media { MediumData media[]; };

vec3 reflectanceProfile(Profile profile, float squaredMm2) {
  return transport == 0u ? dipoleProfile(profile, squaredMm2)
                         : betterDipoleProfile(profile, squaredMm2);
}

#ifdef BINDING_PATTERN
layout(std430, set = 0, binding = BINDING_PATTERN) readonly buffer Pattern { PatternEntry pattern[]; };
layout(set = 0, binding = BINDING_POSITION) uniform sampler2D dsmPosition;
layout(set = 0, binding = BINDING_IRRADIANCE) uniform sampler2D dsmIrradiance;  // filtered linearly

// The near block and the eight far samples around a place in the atlas (Gong et al. 2008,
// section 4.1), each weighted by the texels it stands for (section 4.2). The cell at the centre,
// where the profile is sharpest, is integrated rather than sampled.
vec3 patternSum(vec3 position, vec2 uv, uint object) {
  MediumData medium = media[objects[object].table.x];
  uint first = medium.tables.y;
  ivec2 size = textureSize(dsmPosition, 0);
  ivec2 centre = clamp(ivec2(uv * vec2(size)), ivec2(0), size - 1);

  vec4 cell = pattern[first].value;
  float stretch = texelFetch(dsmPosition, centre, 0).w / cell.a;
  vec3 sum = textureLod(dsmIrradiance, uv, 0.0).rgb * cell.rgb *
             pow(vec3(stretch), pattern[first + 1u].value.rgb);

  float wanted = float(object + 1u);
  for (uint i = first + 2u; i < first + 2u + medium.tables.z; ++i) {
    vec4 tap = pattern[i].value;
    int packed = floatBitsToInt(tap.a);
    ivec2 texel = centre + ivec2(bitfieldExtract(packed, 0, 16), packed >> 16);
    texel = clamp(texel, ivec2(0), size - 1);
    vec4 irradiance = texelFetch(dsmIrradiance, texel, 0);
    vec4 place = texelFetch(dsmPosition, texel, 0);
    vec3 offset = place.xyz - position;
    float area = irradiance.a == wanted ? place.w : 0.0;
    sum += irradiance.rgb * tap.rgb * area *
           reflectanceProfile(medium.profile, dot(offset, offset));
  }
  return sum;
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
    sum += sources[2u * i + 1u].rgb * reflectanceProfile(profile, dot(offset, offset));
  }
  return sum;
}
#endif

#endif
