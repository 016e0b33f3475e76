// Light mirrored on arrival, added up where it enters. Needs BINDING_PEAKS and BINDING_SUMS.
#ifndef OPALINE_LIB_MIRRORED_SUMS
#define OPALINE_LIB_MIRRORED_SUMS
#include "lib/peaks.glsl"
#include "lib/whole_sums.glsl"

layout(std430, set = 0, binding = BINDING_SUMS) buffer Sums { uint sums[]; };  // three per cluster

// A cluster's power from lights that were found together, `clusters` times each. The sums are 0 again afterwards.
vec3 takeMirrored(uint i, uint firstLight, uint lights, uint clusters) {
  vec3 power = vec3(0.0);
  float most = uintBitsToFloat(peaks[firstLight]);
  if (most <= 0.0) return power;
  float whole = wholeOfMost(lights * clusters);
  for (uint c = 0u; c < 3u; ++c) {
    power[c] = float(sums[3u * i + c]) / whole * most;
    sums[3u * i + c] = 0u;
  }
  return power;
}

#endif
