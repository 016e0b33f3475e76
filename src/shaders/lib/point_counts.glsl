// A beam's numbers of points of first and of second collisions, which come of which, and both in one float, exactly.
#ifndef OPALINE_LIB_POINT_COUNTS
#define OPALINE_LIB_POINT_COUNTS
#include "shared/boundary.h"

// Which point of first collisions a second one comes from, and by which of how many directions.
struct Path {
  uint point;
  uint direction;
  uint directions;
};

// Directions from each of the first segment's points but the last, and from that.
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

// Of so many points of first collisions, how many of second ones come.
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
