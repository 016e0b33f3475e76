// What is known at clusters, interpolated between them.
#ifndef OPALINE_LIB_CLUSTER_WEIGHT
#define OPALINE_LIB_CLUSTER_WEIGHT
#include "lib/pi.glsl"
#include "shared/boundary.h"

// Weight of clusters that face away from a place. It is above 0 so that every place has some.
const float leastFacing = 1e-4;

// A cluster whose reach is more than this many of its edges has its surfels far apart.
const float scatteredInEdges = 3.4;

// Edge of a cluster as a square, mm, from its radius as a disc.
float edgeOfDisc(float radius) {
  return sqrt(pi) * radius;
}

float edgeOf(Cluster cluster) {
  return edgeOfDisc(cluster.normal.w);
}

// How much a cluster counts at its middle. A few surfels left over between others, scattered over their
// reach, would otherwise count as much as all around them.
float peakOfCluster(float reachMm, float edgeMm) {
  float fills = min(1.0, scatteredInEdges * edgeMm / max(reachMm, 1e-15));
  return fills * fills;
}

// The part of that at a place, by the squared distance over the reach and the cosine of their normals. It
// falls to 0 where the reach ends, so that nothing jumps.
float fallOfCluster(float squaredInReaches, float facing) {
  float left = max(1.0 - squaredInReaches, 0.0);
  return left * left * max(facing, leastFacing);
}

float weightOfCluster(float squaredMm2, float reachMm, float edgeMm, float facing) {
  return peakOfCluster(reachMm, edgeMm) * fallOfCluster(squaredMm2 / max(reachMm * reachMm, 1e-30), facing);
}

#endif
