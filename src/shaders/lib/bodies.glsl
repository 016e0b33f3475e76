// The bodies and what they are made of. Needs, before it, BINDING_OBJECTS and BINDING_MEDIA.
#ifndef OPALINE_LIB_BODIES
#define OPALINE_LIB_BODIES
#include "shared/frame.h"
#include "shared/medium.h"

layout(std430, set = 0, binding = BINDING_OBJECTS) readonly buffer Objects { ObjectData objects[]; };
layout(std430, set = 0, binding = BINDING_MEDIA) readonly buffer Media { MediumData media[]; };

// Where a sum is asked for: 0 as each object has it, 1 at vertices, 2 at fragments.
bool isSummedAtFragments(ObjectData body, uint site) {
  return site == 2u || site == 0u && body.table.w != 0u;
}

#endif
