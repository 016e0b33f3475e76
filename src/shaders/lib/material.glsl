// What bodies are made of, and the only access to it. Needs, before it, BINDING_OBJECTS and BINDING_MEDIA.
#ifndef OPALINE_LIB_MATERIAL
#define OPALINE_LIB_MATERIAL
#include "lib/bodies.glsl"
#include "shared/medium.h"

layout(std430, set = 0, binding = BINDING_MEDIA) readonly buffer Media { MediumData media[]; };

// The medium at a place of a body's surface, mm. A body has one medium all over.
MediumData mediumAt(ObjectData body, vec3 place) {
  return media[body.table.x];
}

// Whether its surface has a roughness or normals of its own, from material tables.y.
bool hasOwnSurface(MediumData medium) {
  return medium.surface.x != 0u;
}

// What light that diffuses through the whole of a body meets there.
BoundaryMedium insideOf(ObjectData body) {
  return media[body.table.x].inside;
}

#endif
