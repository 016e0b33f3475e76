// Where a corner of the atlas lies in the map of neighbourhoods, in [0,1]²; with BINDING_CORNERS, the
// first of three bindings, places between corners too.
#ifndef OPALINE_LIB_PLACE
#define OPALINE_LIB_PLACE
#include "paper/shaders/shared/atlas.h"

vec2 nearPlace(AtlasCorner corner, ChartPlace chart) {
  return vec2(corner.u, corner.v) * chart.scale + vec2(chart.shiftU, chart.shiftV);
}

#ifdef BINDING_CORNERS
layout(std430, set = 0, binding = BINDING_CORNERS) readonly buffer Corners { AtlasCorner corners[]; };
layout(std430, set = 0, binding = BINDING_CORNERS + 1) readonly buffer CornerIndices { uint cornerIndices[]; };
layout(std430, set = 0, binding = BINDING_CORNERS + 2) readonly buffer Charts { ChartPlace charts[]; };

// The place on a triangle with these weights of the corners.
vec2 nearPlaceOn(uint triangle, vec3 weights) {
  vec2 place = vec2(0.0);
  for (uint i = 0u; i < 3u; ++i) {
    AtlasCorner corner = corners[cornerIndices[3u * triangle + i]];
    place += weights[i] * nearPlace(corner, charts[corner.chart]);
  }
  return place;
}
#endif

#endif
