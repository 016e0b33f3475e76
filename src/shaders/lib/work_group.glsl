// A work group for each element of a list, whose invocations share the work for it; see CommandList::dispatchGroups.
// The device says how many they are (gpu::WorkGroups): with TILE_WORK defined for what acts on the clusters of a tile,
// and with LONG_WORK for loops of half a million rounds in all.
#ifndef OPALINE_LIB_WORK_GROUP
#define OPALINE_LIB_WORK_GROUP

#if defined(LONG_WORK)
layout(local_size_x = 64, local_size_x_id = 17) in;
#elif defined(TILE_WORK)
layout(local_size_x = 64, local_size_x_id = 20) in;
#else
layout(local_size_x = 64, local_size_x_id = 16) in;
#endif

uint groupIndex() {
  return gl_WorkGroupID.x + gl_WorkGroupID.y * gl_NumWorkGroups.x;
}

#endif
