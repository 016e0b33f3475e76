// What is known at clusters, interpolated between them.
#ifndef OPALINE_LIB_CLUSTER_WEIGHT
#define OPALINE_LIB_CLUSTER_WEIGHT
#include "lib/pi.glsl"
#include "shared/boundary.h"

// Of clusters that face away from a place; above 0, so that every place has some.
const float leastFacing = 1e-4;

// Clusters whose reach is more than that many of their edges have their surfels far apart.
const float scatteredInEdges = 3.4;

// Edge of a cluster as a square, mm.
float edgeOf(Cluster cluster) {
  return sqrt(pi) * cluster.normal.w;
}

// How much a cluster counts at a place, by their distance and the cosine of their normals: falls to 0
// where its reach ends, so that nothing jumps. Clusters that are scattered over their reach, a few surfels
// left over between others, would count as much as all around them.
float weightOfCluster(float squaredMm2, float reachMm, float edgeMm, float facing) {
  float left = 1.0 - squaredMm2 / max(reachMm * reachMm, 1e-30);
  if (left <= 0.0) return 0.0;
  float fills = min(1.0, scatteredInEdges * edgeMm / max(reachMm, 1e-15));
  return fills * fills * left * left * max(facing, leastFacing);
}

#endif
