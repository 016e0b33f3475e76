// Places in the atlas and in the two maps of neighbourhoods, all in [0,1]².
#ifndef OPALINE_LIB_PLACE
#define OPALINE_LIB_PLACE
#include "shared/mesh.h"

vec2 nearPlaceOf(vec2 uv, ChartPlaces chart) {
  return uv * chart.nearScale + vec2(chart.nearShiftU, chart.nearShiftV);
}

vec2 farPlaceOf(vec2 nearPlace, ChartPlaces chart) {
  vec2 uv = (nearPlace - vec2(chart.nearShiftU, chart.nearShiftV)) / chart.nearScale;
  return uv * chart.farScale + vec2(chart.farShiftU, chart.farShiftV);
}

#endif
