// Lists, in any order, pixels whose samples see several triangles. Needs, before it, BINDING_MIXED, the first of two
// bindings.
#ifndef OPALINE_LIB_MIXED
#define OPALINE_LIB_MIXED
#include "lib/groups.glsl"
#include "shared/seen.h"

layout(std430, set = 0, binding = BINDING_MIXED) writeonly buffer Mixed { uint mixed[]; };
layout(std430, set = 0, binding = BINDING_MIXED + 1) buffer MixedCount { SeenCount mixedCount; };

void listMixed(bool several, uint pixel) {
  uint added = several ? 1u : 0u;
  uint before = subgroupExclusiveAdd(added);
  uint all = subgroupAdd(added);
  uint start = 0u;
  if (subgroupElect() && all != 0u) {
    start = atomicAdd(mixedCount.groupsEntries.w, all);
    atomicMax(mixedCount.groupsEntries.x, groupsFor(start + all));
    atomicMax(mixedCount.groupsEntries.y, 1u);
    atomicMax(mixedCount.groupsEntries.z, 1u);
  }
  start = subgroupMax(start);
  if (several) mixed[start + before] = pixel;
}

#endif
