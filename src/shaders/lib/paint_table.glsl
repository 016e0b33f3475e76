// What a paint's colours stand for. Needs, before it, BINDING_PAINT_TABLES.
#ifndef OPALINE_LIB_PAINT_TABLE
#define OPALINE_LIB_PAINT_TABLE
#include "shared/medium.h"
#include "shared/paint.h"

layout(std430, set = 0, binding = BINDING_PAINT_TABLES) readonly buffer PaintTables { PaintEntry paintTables[]; };

bool isPainted(MediumData medium) {
  return medium.tables.z != 0u;
}

// The layer that gives a painted medium that colour.
PaintEntry paintOf(MediumData medium, vec3 color) {
  uint first = (medium.tables.z - 1u) * (paintEntries + 1u);
  vec3 bare = paintTables[first + paintEntries].thickness.rgb;
  vec3 at = sqrt(clamp(color / max(bare, vec3(1e-6)), 0.0, 1.0)) * float(paintEntries - 1u);
  PaintEntry found;
  for (int c = 0; c < 3; ++c) {
    uint low = min(uint(at[c]), paintEntries - 2u);
    float part = at[c] - float(low);
    PaintEntry a = paintTables[first + low];
    PaintEntry b = paintTables[first + low + 1u];
    found.thickness[c] = mix(a.thickness[c], b.thickness[c], part);
    found.entering[c] = mix(a.entering[c], b.entering[c], part);
    found.layer[c] = mix(a.layer[c], b.layer[c], part);
    found.leaving[c] = mix(a.leaving[c], b.leaving[c], part);
    found.takenOff[c] = mix(a.takenOff[c], b.takenOff[c], part);
    found.source[c] = mix(a.source[c], b.source[c], part);
    found.deep[c] = mix(a.deep[c], b.deep[c], part);
  }
  return found;
}

#endif
