// The bodies. Needs, before it, BINDING_OBJECTS.
#ifndef OPALINE_LIB_BODIES
#define OPALINE_LIB_BODIES
#include "shared/frame.h"

layout(std430, set = 0, binding = BINDING_OBJECTS) readonly buffer Objects { ObjectData objects[]; };

// Where sums are wanted: 0 as each object says, 1 at vertices, 2 at fragments.
bool isSummedAtFragments(ObjectData body, uint site) {
  return site == 2u || site == 0u && body.table.w != 0u;
}

// Whether no light enters it.
bool isOpaque(ObjectData body) {
  return body.clusters.w != 0u;
}

// Whether an opaque body lets light through to its other side.
bool letsThrough(ObjectData body) {
  return body.clusters.w == 2u;
}

// Whether its back receives light of its own.
bool hasBack(ObjectData body) {
  return body.tree.z != 0u;
}

// The cluster of the back of such a body for one of its front, and the other way round.
uint backOf(uint cluster, ObjectData body) {
  return cluster + body.tree.z;
}

uint frontOf(uint cluster, ObjectData body) {
  return cluster - body.tree.z;
}

#endif
