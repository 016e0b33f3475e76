// Adds to the lists of shared/seen.h. Work groups come in any order, but each adds whole subgroups, the last of them
// filled up. The neighbours in a subgroup that goes over the list are then always the same, which matters because a
// device's filter of cubes may round differently where a neighbour is at a corner. A work group lists what 64 entries
// want, in rounds if it is smaller. Needs, before it, BINDING_SURFACES, the first of two bindings, and the size of a
// work group.
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

// Takes that many entries; returns the first.
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

const uint mostRounds = groupSize / 8u;

// A work group that needs several rounds is one subgroup (gpu::WorkGroups).
uint roundsOfListing() {
  return groupSize / gl_WorkGroupSize.x;
}

// Which of the 64 an invocation has in a round.
uint placeInRounds(uint round) {
  return round * gl_WorkGroupSize.x + gl_LocalInvocationIndex;
}

// The first of that many entries, which one invocation takes for the whole work group.
uint takePlacesTogether(uint all) {
  if (roundsOfListing() > 1u) return subgroupMax(subgroupElect() ? takePlaces(all) : 0u);
  if (gl_LocalInvocationIndex == 0u) startOfGroup = takePlaces(all);
  barrier();
  return startOfGroup;
}

uint placeInRound(uint wanted, out uint all) {
  if (roundsOfListing() == 1u) return groupPlaceFor(wanted, all);
  all = subgroupAdd(wanted);
  return subgroupExclusiveAdd(wanted);
}

// Takes places for a work group all at once and in order, so that neighbours stay together. Replaces how many entries
// an invocation wants in each round by the first of them.
void placesForSurfaces(inout uint places[mostRounds]) {
  uint all = 0u;
  for (uint round = 0u; round < roundsOfListing(); ++round) {
    uint ofRound;
    places[round] = all + placeInRound(places[round], ofRound);
    all += ofRound;
  }
  if (all == 0u) return;
  uint width = min(gl_SubgroupSize, gl_WorkGroupSize.x);
  uint filled = (all + width - 1u) / width * width;
  uint start = takePlacesTogether(filled);
  for (uint round = 0u; round < roundsOfListing(); ++round) places[round] += start;
  if (all + gl_LocalInvocationIndex < filled) surfaces[start + all + gl_LocalInvocationIndex] = noSurface;
}

// The same in one round.
uint placesForSurfaces(uint added) {
  uint places[mostRounds];
  places[0] = added;
  placesForSurfaces(places);
  return places[0];
}

#endif
