// One invocation for each element of a list of any length; see CommandList::dispatchLinear.
#ifndef OPALINE_LIB_LINEAR
#define OPALINE_LIB_LINEAR

#if defined(SHARED_WALKS)
layout(local_size_x = 64, local_size_y = 1, local_size_y_id = 21) in;  // lib/sharers.glsl
#else
layout(local_size_x = 64) in;
#endif

uint linearIndex() {
  return gl_GlobalInvocationID.x + gl_WorkGroupID.y * (gl_NumWorkGroups.x * gl_WorkGroupSize.x);
}

#endif
