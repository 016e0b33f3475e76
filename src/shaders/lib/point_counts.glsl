// A beam's numbers of points of first and of second collisions, and both in one float, exactly.
#ifndef OPALINE_LIB_POINT_COUNTS
#define OPALINE_LIB_POINT_COUNTS
#include "shared/boundary.h"

// Directions in which the p-th point of first collisions is followed on.
uint directionsFrom(uint p) {
  return p < pointsOfFirstSegment ? directionsOfPoint : 1u;
}

// Of so many points of first collisions, how many of second ones come.
uint secondPointsOf(uint first) {
  return first + min(first, pointsOfFirstSegment) * (directionsOfPoint - 1u);
}

const float secondCountsFrom = 64.0;

float packPointCounts(uint first, uint second) {
  return float(first) + secondCountsFrom * float(second);
}

uvec2 unpackPointCounts(float counts) {
  float second = floor(counts / secondCountsFrom);
  return uvec2(uint(counts - secondCountsFrom * second), uint(second));
}

#endif
