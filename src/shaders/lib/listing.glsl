// Adds to the lists of shared/seen.h. Work groups come in any order, but each adds whole subgroups, the last of them filled
// up, so that the neighbours in a subgroup that goes over the list are always the same: a device's filter of cubes may round
// otherwise where a neighbour is at a corner. Needs, before it, BINDING_SURFACES, the first of two bindings, and the size of
// a work group, 64.
#ifndef OPALINE_LIB_LISTING
#define OPALINE_LIB_LISTING
#include "lib/group_place.glsl"
#include "lib/groups.glsl"
#include "shared/seen.h"

layout(std430, set = 0, binding = BINDING_SURFACES) writeonly buffer Surfaces { uint surfaces[]; };
layout(std430, set = 0, binding = BINDING_SURFACES + 1) buffer SurfaceCounts { SeenCount surfaceCounts[]; };

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

shared uint startOfGroup;

// Of a work group, all at once and in order, so that neighbours stay together: the first entry of each invocation's
// that wants `added` of them.
uint placesForSurfaces(uint added) {
  uint all;
  uint before = groupPlaceFor(added, all);
  if (all == 0u) return 0u;
  uint width = min(gl_SubgroupSize, gl_WorkGroupSize.x);
  uint filled = (all + width - 1u) / width * width;
  if (gl_LocalInvocationIndex == 0u) startOfGroup = takePlaces(filled);
  barrier();
  if (all + gl_LocalInvocationIndex < filled) surfaces[startOfGroup + all + gl_LocalInvocationIndex] = noSurface;
  return startOfGroup + before;
}

#endif
