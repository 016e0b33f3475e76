// Profiles of a list of radii, as the passes compute them.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"
#include "lib/profile.glsl"

layout(std430, set = 0, binding = 0) readonly buffer Packed { Profile packed; };
layout(std430, set = 0, binding = 1) readonly buffer Radii { float squaredMm2[]; };
layout(std430, set = 0, binding = 2) writeonly buffer Values { vec4 values[]; };

layout(push_constant) uniform Push {
  uint count;
  uint better;
};

void main() {
  uint i = linearIndex();
  if (i >= count) return;
  values[i] = vec4(better != 0u ? betterDipoleProfile(packed, squaredMm2[i])
                                : dipoleProfile(packed, squaredMm2[i]),
                   0.0);
}
