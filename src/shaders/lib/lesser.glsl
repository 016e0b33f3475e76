// Minima and maxima of numbers none of which is NaN. min() and max() return the other number for a
// NaN, which takes Mesa's software device three instructions instead of one.
#ifndef OPALINE_LIB_LESSER
#define OPALINE_LIB_LESSER

float lesser(float a, float b) {
  return a < b ? a : b;
}

float greater(float a, float b) {
  return a > b ? a : b;
}

float leastOf(vec3 v) {
  return lesser(lesser(v.x, v.y), v.z);
}

float largestOf(vec3 v) {
  return greater(greater(v.x, v.y), v.z);
}

#endif
