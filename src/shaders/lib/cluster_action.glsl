// What a node of the tree of clusters gives the fluence at a cluster, by the operator of the boundary's equation.
// Needs, before it, BINDING_CLUSTER_NODES, what lib/cluster_tile.glsl needs, and what lib/way_between.glsl needs.
#ifndef OPALINE_LIB_CLUSTER_ACTION
#define OPALINE_LIB_CLUSTER_ACTION
#include "lib/cluster_node.glsl"
#include "lib/cluster_tile.glsl"
#include "lib/way_between.glsl"

// A node, as every cluster of the tile needs it.
struct ActingNode {
  vec3 place;
  bool leaf;
  float radius;   // of all below it
  float area;
  vec3 second;    // how much more its single layer gives from afar than from its middle
  uint cluster;   // of a leaf
  Moment moment;
};

// Also sets the way from there.
ActingNode actingNode(uint at) {
  vec4 centroidLink = centroidLinkOf(at);
  vec4 spread = spreadOf(at);
  uint link = floatBitsToUint(centroidLink.w);
  takeWayFrom(at);
  return ActingNode(centroidLink.xyz, isLeaf(link), spread.x, spread.w,
                    1.0 + way.sigma * way.sigma * (spread.y / 6.0), firstSurfelOf(link), momentOf(at));
}

// What a node's densities give, for each channel.
struct Action {
  vec3 ofDensity;  // times Σ a φ
  vec3 ofDipole;   // times the dipole along the way there, and subtracted
};

Action noAction() {
  return Action(vec3(0.0), vec3(0.0));
}

// The action on the tile's cluster t: a single layer of that weight as from the node's middle, and a double
// layer of the node's dipole. A cluster does not act on itself.
Action actionOn(uint t, ActingNode node, vec3 weightS, float openingAngle) {
  if (node.leaf && node.cluster == tile.firstCluster + t) return noAction();
  vec4 target = targets[t];
  vec3 sigma = way.sigma;
  vec3 offset = node.place - target.xyz;
  float squared = dot(offset, offset);
  if (squared <= leastSquaredMm2) return noAction();
  float over = inversesqrt(squared);
  float over2 = over * over;
  vec3 x = sigma * (squared * over);
  vec3 e = exp(-x) * over2 * over;
  vec3 single;
  if (node.leaf) {
    float depth = dot(offset, targetNormals[t].xyz);
    single = kernelBetween(discsBetween(target.w, node.area, medium), sigma, vec3(squared), vec3(depth));
  } else {
    single = kernel(vec3(squared + smoothingOf(target.w, 0.0)));
  }
  single *= weightS * way.overDiffusion;
  vec3 along = e * (1.0 + x);
  if (node.leaf) {
    // The expansion about the middle holds only for places outside.
    if (isFar(squared, node.radius, leastSigma, openingAngle)) single *= node.second;
    return Action(single, coverageOfDisc(squared, node.area) * along);
  }
  // The moment accounts for both sides of a sheet, whose areas cancel.
  vec3 sheet = (3.0 + x * (3.0 + x)) * (over2 * alongTwice(node.moment, offset)) -
               (1.0 + x) * traceOf(node.moment);
  return Action(single * node.second + e * sheet / max(node.area, 1e-30), along);
}

// The fluence from the dipoles on a node, a column for each channel, and Σ a φ.
vec3 fluenceBy(Action action, vec3 offset, mat3 dipoles, vec3 density) {
  return action.ofDensity * density - action.ofDipole * (offset * dipoles);
}

#endif
