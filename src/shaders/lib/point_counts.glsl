// A cluster's numbers of points of first and of second collisions in one float, exactly.
#ifndef OPALINE_LIB_POINT_COUNTS
#define OPALINE_LIB_POINT_COUNTS

const float secondCountsFrom = 64.0;

float packPointCounts(uint first, uint second) {
  return float(first) + secondCountsFrom * float(second);
}

uvec2 unpackPointCounts(float counts) {
  float second = floor(counts / secondCountsFrom);
  return uvec2(uint(counts - secondCountsFrom * second), uint(second));
}

#endif
