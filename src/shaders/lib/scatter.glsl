// What every sum of sources (Eq. 8) reads. Needs, before it, BINDING_OBJECTS and BINDING_MEDIA.
#ifndef OPALINE_LIB_SCATTER
#define OPALINE_LIB_SCATTER
#include "lib/material.glsl"
#include "lib/profile.glsl"

layout(constant_id = 0) const uint transport = 0u;  // 0: dipole, 1: better dipole

// Takes a squared distance for each channel.
vec3 reflectanceProfile(Profile profile, vec3 squaredMm2) {
  return transport == 0u ? dipoleProfile(profile, squaredMm2)
                         : betterDipoleProfile(profile, squaredMm2);
}

#endif
