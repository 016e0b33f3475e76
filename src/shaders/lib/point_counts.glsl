// How many points of first and of second collisions a beam has, which of these come from which, and both numbers in
// one float, exactly.
#ifndef OPALINE_LIB_POINT_COUNTS
#define OPALINE_LIB_POINT_COUNTS
#include "shared/boundary.h"

// Which point of first collisions a second one comes from, and by which of how many directions.
struct Path {
  uint point;
  uint direction;
  uint directions;
};

// Directions from each of the first segment's points but the last, and from the last.
uvec2 directionsOfSegment(bool comesFromEverywhere) {
  return comesFromEverywhere ? uvec2(directionsOfEvenPoint, directionsOfLastEvenPoint)
                             : uvec2(directionsOfPoint, directionsOfLastPoint);
}

Path pathTo(uint second, bool comesFromEverywhere) {
  const uint last = pointsOfFirstSegment - 1u;
  uvec2 directions = directionsOfSegment(comesFromEverywhere);
  if (second < last * directions.x) return Path(second / directions.x, second % directions.x, directions.x);
  uint further = second - last * directions.x;
  return further < directions.y ? Path(last, further, directions.y)
                                : Path(pointsOfFirstSegment + further - directions.y, 0u, 1u);
}

// How many points of second collisions come from that many of first ones.
uint secondPointsOf(uint first, bool comesFromEverywhere) {
  uvec2 directions = directionsOfSegment(comesFromEverywhere);
  return first == 0u ? 0u
                     : (pointsOfFirstSegment - 1u) * directions.x + directions.y + first - pointsOfFirstSegment;
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
