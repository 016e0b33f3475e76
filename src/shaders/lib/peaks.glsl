// The largest numbers of all clusters (shared/boundary.h). Needs, before it, BINDING_PEAKS, and PEAKS_WRITTEN where it
// is to raise them.
#ifndef OPALINE_LIB_PEAKS
#define OPALINE_LIB_PEAKS
#include "shared/boundary.h"

#ifdef PEAKS_WRITTEN
layout(std430, set = 0, binding = BINDING_PEAKS) buffer Peaks { uint peaks[]; };
#else
layout(std430, set = 0, binding = BINDING_PEAKS) readonly buffer Peaks { uint peaks[]; };
#endif

vec3 mostEntered(uint which) {
  uint at = peaksOfMirrored + 3u * which;
  return vec3(uintBitsToFloat(peaks[at]), uintBitsToFloat(peaks[at + 1u]), uintBitsToFloat(peaks[at + 2u]));
}

#ifdef PEAKS_WRITTEN
void noteEntered(uint which, vec3 irradiance) {
  for (uint c = 0u; c < 3u; ++c)
    atomicMax(peaks[peaksOfMirrored + 3u * which + c], floatBitsToUint(irradiance[c]));
}
#endif

#endif
