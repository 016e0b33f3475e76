// Invocations that share a walk: to each element of a list belong those of one gl_LocalInvocationID.x, as many as the
// device says (gpu::WorkGroups). Neighbours in a subgroup have neighbours on the list and the same part of the walk.
#ifndef OPALINE_LIB_SHARERS
#define OPALINE_LIB_SHARERS
#define SHARED_WALKS
#include "lib/linear.glsl"

const uint sharers = gl_WorkGroupSize.y;

uint sharer() {
  return gl_LocalInvocationID.y;
}

shared vec4 partsOfSharers[gl_WorkGroupSize.x * gl_WorkGroupSize.y];

// Every invocation of the group calls it.
vec4 sumOfSharers(vec4 part) {
  if (sharers == 1u) return part;
  partsOfSharers[gl_LocalInvocationIndex] = part;
  barrier();
  vec4 sum = vec4(0.0);
  for (uint s = 0u; s < sharers; ++s) sum += partsOfSharers[s * gl_WorkGroupSize.x + gl_LocalInvocationID.x];
  return sum;
}

#endif
