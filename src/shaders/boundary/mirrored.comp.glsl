// Light mirrored on arrival, brought to the clusters where it enters: first added up in whole
// numbers, then turned into power.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"
#include "lib/whole_sums.glsl"
#include "shared/boundary.h"

layout(constant_id = 0) const uint addsUp = 1u;

layout(std430, set = 0, binding = 0) readonly buffer MirroredLight { Mirrored mirrored[]; };
layout(std430, set = 0, binding = 1) readonly buffer Peaks { uint peaks[]; };  // for the first of the lights that are
                                                                               // found together
layout(std430, set = 0, binding = 2) buffer Sums { uint sums[]; };  // three per cluster, and 0 again afterwards
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
  if (addsUp == 0u && adds == 0u) arrived[i] = vec4(0.0);
  float most = uintBitsToFloat(peaks[firstLight]);
  if (most <= 0.0) return;
  float whole = wholeOfMost(lights * clusterCount);
  if (addsUp == 0u) {
    for (uint c = 0u; c < 3u; ++c) {
      arrived[i][c] += float(sums[3u * i + c]) / whole * most;
      sums[3u * i + c] = 0u;
    }
    return;
  }
  Mirrored its = mirrored[i];
  if (its.cluster == noCluster) return;
  uvec3 parts = uvec3(its.power.rgb / most * whole);
  for (uint c = 0u; c < 3u; ++c)
    if (parts[c] > 0u) atomicAdd(sums[3u * its.cluster + c], parts[c]);
}
