// What is known at clusters, interpolated between them.
#ifndef OPALINE_LIB_CLUSTER_WEIGHT
#define OPALINE_LIB_CLUSTER_WEIGHT
#include "lib/pi.glsl"
#include "shared/boundary.h"

// Of clusters that face away from a place; above 0, so that every place has some.
const float leastFacing = 1e-4;

// Clusters whose reach is more than that many of their edges have their surfels far apart.
const float scatteredInEdges = 3.4;

// Edge of a cluster as a square, mm, by that of it as a disc.
float edgeOfDisc(float radius) {
  return sqrt(pi) * radius;
}

float edgeOf(Cluster cluster) {
  return edgeOfDisc(cluster.normal.w);
}

// How much a cluster counts at its middle. Clusters that are scattered over their reach, a few surfels left
// over between others, would count as much as all around them.
float peakOfCluster(float reachMm, float edgeMm) {
  float fills = min(1.0, scatteredInEdges * edgeMm / max(reachMm, 1e-15));
  return fills * fills;
}

// The part of that at a place, by its distance over the reach, squared, and the cosine of their normals: falls
// to 0 where the reach ends, so that nothing jumps.
float fallOfCluster(float squaredInReaches, float facing) {
  float left = max(1.0 - squaredInReaches, 0.0);
  return left * left * max(facing, leastFacing);
}

float weightOfCluster(float squaredMm2, float reachMm, float edgeMm, float facing) {
  return peakOfCluster(reachMm, edgeMm) * fallOfCluster(squaredMm2 / max(reachMm * reachMm, 1e-30), facing);
}

#endif
