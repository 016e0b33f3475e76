// Where a corner of the atlas lies in the map of neighbourhoods, in [0,1]². `chart` holds the scale
// (z) and the shift (xy) of its chart.
#ifndef OPALINE_LIB_PLACE
#define OPALINE_LIB_PLACE
#include "shared/mesh.h"

vec2 placeAmongNeighbours(AtlasCorner corner, vec4 chart) {
  return vec2(corner.u, corner.v) * chart.z + chart.xy;
}

#endif
