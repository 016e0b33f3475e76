// What sums over the tree tolerate.
#ifndef OPALINE_LIB_TOLERANCE
#define OPALINE_LIB_TOLERANCE

// A channel much darker than another is not asked for more than the eye could tell.
const float leastOfBrightest = 0.05;

// The error of one node, where it is about as bright as `exitance`.
vec3 toleratedAt(vec3 exitance, float tolerance) {
  float brightest = max(max(exitance.r, exitance.g), exitance.b);
  return tolerance * max(exitance, vec3(leastOfBrightest * brightest));
}

// The same, or all where there is no estimate of it.
vec3 toleratedIn(vec3 estimate, float tolerance, bool estimated) {
  return estimated ? toleratedAt(estimate, tolerance) : vec3(3e38);
}

#endif
