// Light mirrored on arrival, brought to the clusters where it enters: added up in whole numbers. If further lights
// follow, it is then turned into power; else boundary/reentry.comp.glsl does so.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_PEAKS 1
#define BINDING_SUMS 2
#include "lib/linear.glsl"
#include "lib/mirrored_sums.glsl"
#include "shared/boundary.h"

layout(constant_id = 0) const uint addsUp = 1u;

layout(std430, set = 0, binding = 0) readonly buffer MirroredLight { Mirrored mirrored[]; };
layout(std430, set = 0, binding = 3) buffer Arrived { vec4 arrived[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
  uint firstLight;
  uint lights;
  uint adds;  // 1: adds to what other lights gave
};

void main() {
  uint i = linearIndex();
  if (i >= (addsUp != 0u ? lights : 1u) * clusterCount) return;
  if (addsUp == 0u) {
    vec3 before = adds != 0u ? arrived[i].rgb : vec3(0.0);
    arrived[i] = vec4(before + takeMirrored(i, firstLight, lights, clusterCount), 0.0);
    return;
  }
  float most = uintBitsToFloat(peaks[firstLight]);
  if (most <= 0.0) return;
  float whole = wholeOfMost(lights * clusterCount);
  Mirrored its = mirrored[i];
  if (its.cluster == noCluster) return;
  uvec3 parts = uvec3(its.power.rgb / most * whole);
  for (uint c = 0u; c < 3u; ++c)
    if (parts[c] > 0u) atomicAdd(sums[3u * its.cluster + c], parts[c]);
}
