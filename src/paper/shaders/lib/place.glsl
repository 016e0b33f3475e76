// Where a corner of the atlas lies in the map of neighbourhoods, in [0,1]².
#ifndef OPALINE_LIB_PLACE
#define OPALINE_LIB_PLACE
#include "paper/shaders/shared/atlas.h"

vec2 nearPlace(AtlasCorner corner, ChartPlace chart) {
  return vec2(corner.u, corner.v) * chart.scale + vec2(chart.shiftU, chart.shiftV);
}

#endif
