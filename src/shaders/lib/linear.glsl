// One invocation for each element of a list of any length; see CommandList::dispatchLinear.
#ifndef OPALINE_LIB_LINEAR
#define OPALINE_LIB_LINEAR

layout(local_size_x = 64) in;

uint linearIndex() {
  return gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * gl_WorkGroupSize.x);
}

#endif
