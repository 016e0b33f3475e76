// Adds to the lists of shared/seen.h. Their order is whatever it happens to be. Needs, before it,
// BINDING_SURFACES, the first of two bindings.
#ifndef OPALINE_LIB_LISTING
#define OPALINE_LIB_LISTING
#include "shared/seen.h"

layout(std430, set = 0, binding = BINDING_SURFACES) writeonly buffer Surfaces { uint surfaces[]; };
layout(std430, set = 0, binding = BINDING_SURFACES + 1) buffer SurfaceCounts { SeenCount surfaceCounts[]; };

const uint groupSize = 64u;

uint groupsFor(uint entries) {
  return (entries + groupSize - 1u) / groupSize;
}

void dispatchAtLeast(uint which, uint entries) {
  atomicMax(surfaceCounts[which].groupsEntries.x, groupsFor(entries));
  atomicMax(surfaceCounts[which].groupsEntries.y, 1u);
  atomicMax(surfaceCounts[which].groupsEntries.z, 1u);
}

// The first of so many entries.
uint takePlaces(uint all) {
  uint start = atomicAdd(surfaceCounts[0].groupsEntries.w, all);
  uint last = start + all - 1u;
  dispatchAtLeast(0u, last + 1u);
  uint part = last / seenOfPart;
  dispatchAtLeast(1u + part, last % seenOfPart + 1u);
  if (start / seenOfPart != part) dispatchAtLeast(part, seenOfPart);
  return start;
}

// Of a subgroup, all at once: the first entry of each invocation's that wants `added` of them.
uint placesForSurfaces(uint added) {
  uint before = subgroupExclusiveAdd(added);
  uint all = subgroupAdd(added);
  uint start = 0u;
  if (subgroupElect() && all != 0u) start = takePlaces(all);
  return subgroupMax(start) + before;
}

#endif
