// What every sum of sources (Eq. 8) reads. Needs, before it, BINDING_OBJECTS and BINDING_MEDIA.
#ifndef OPALINE_LIB_SCATTER
#define OPALINE_LIB_SCATTER
#include "shared/frame.h"
#include "shared/medium.h"
#include "lib/profile.glsl"

layout(constant_id = 0) const uint transport = 0u;  // 0: dipole, 1: better dipole

layout(std430, set = 0, binding = BINDING_OBJECTS) readonly buffer Objects { ObjectData objects[]; };
layout(std430, set = 0, binding = BINDING_MEDIA) readonly buffer Media { MediumData media[]; };

// Where a sum is asked for: 0 as each object has it, 1 at vertices, 2 at fragments.
bool isSummedAtFragments(ObjectData body, uint site) {
  return site == 2u || site == 0u && body.table.w != 0u;
}

// Of a distance for each channel, squared.
vec3 reflectanceProfile(Profile profile, vec3 squaredMm2) {
  return transport == 0u ? dipoleProfile(profile, squaredMm2)
                         : betterDipoleProfile(profile, squaredMm2);
}

#endif
