// Invocations side by side that share the work for one thing: one of them, or a power of two no more than a work group,
// as the device says (gpu::WorkGroups). See CommandList::dispatchLanes. Needs, before it, the group's size.
#ifndef OPALINE_LIB_LANES
#define OPALINE_LIB_LANES

layout(constant_id = 18) const uint lanes = 1u;

shared vec4 termsOfLanes[gl_WorkGroupSize.x];

// Every invocation of the group calls it, and all those of a thing get the same sum, bit by bit.
vec4 sumOfLanes(vec4 term) {
  for (uint apart = 1u; apart < lanes; apart *= 2u) {
    termsOfLanes[gl_LocalInvocationIndex] = term;
    barrier();
    term += termsOfLanes[gl_LocalInvocationIndex ^ apart];
    barrier();
  }
  return term;
}

#endif
