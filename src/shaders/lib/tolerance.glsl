// What sums over the tree tolerate.
#ifndef OPALINE_LIB_TOLERANCE
#define OPALINE_LIB_TOLERANCE

// A channel much darker than another need not be more exact than the eye can tell.
const float leastOfBrightest = 0.05;

// The error tolerated of one node where it is about as bright as `exitance`.
vec3 toleratedAt(vec3 exitance, float tolerance) {
  float brightest = max(max(exitance.r, exitance.g), exitance.b);
  return tolerance * max(exitance, vec3(leastOfBrightest * brightest));
}

#endif
