// How much clusters count for a mean around another one.
#ifndef OPALINE_LIB_AROUND_CLUSTER
#define OPALINE_LIB_AROUND_CLUSTER
#include "lib/cluster_weight.glsl"

// By what lies between their middles, their normals, and how far the other is felt.
float weightAround(vec3 offset, vec3 normal, vec3 otherNormal, float reachMm) {
  float near = max(1.0 - dot(offset, offset) / max(reachMm * reachMm, 1e-30), 0.0);
  return near * max(dot(normal, otherNormal), leastFacing);
}

#endif
