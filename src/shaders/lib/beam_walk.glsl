// Sums, at every cluster, over the points of light below all others: bindings and the way through
// the tree. Needs, before it, lib/linear.glsl and, after it, two functions of `its`, the cluster that
// receives (the discs of its own light are added beside the walk, where hasOwnLeaf):
//   vec3 fromNode(BeamNode node, vec3 squared)  light of all below a node
//   vec3 fromPoints(uint cluster)               light of a cluster's points, one by one; of its
//                                               own without those that are discs
#ifndef OPALINE_LIB_BEAM_WALK
#define OPALINE_LIB_BEAM_WALK
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_POINTS 2
#define BINDING_STRENGTHS 3
#include "lib/beam.glsl"

layout(set = 0, binding = 4) uniform samplerBuffer beamNodes;  // BeamNode
layout(std430, set = 0, binding = 5) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 6) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 7) buffer Sums { vec4 sums[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
  float openingAngle;
  uint adds;  // 1: to what other light and other nodes gave
  uint firstNode;
  uint endNode;
};

uint receiver;
Cluster its;
ObjectData body;
BoundaryMedium medium;

BeamNode readBeamNode(uint index) {
  int first = 6 * int(index);
  return BeamNode(texelFetch(beamNodes, first), texelFetch(beamNodes, first + 1),
                  texelFetch(beamNodes, first + 2), texelFetch(beamNodes, first + 3),
                  texelFetch(beamNodes, first + 4), texelFetch(beamNodes, first + 5));
}

vec3 fromNode(BeamNode node, vec3 squared);
vec3 fromPoints(uint cluster);

// To be called first: those of the last group that are too many stand for the first cluster.
void receive() {
  uint i = linearIndex();
  receiver = i < clusterCount ? i : 0u;
  its = clusters[receiver];
  body = objects[ranges[receiver].object];
  medium = insideOf(body);
}

// Whether the nodes of this dispatch have the receiver's own leaf.
bool hasOwnLeaf() {
  uint own = ranges[receiver].node;
  return own >= firstNode && own < endNode;
}

// Of the nodes of this dispatch. `reachMm` is where no light of any comes from further; the
// invocations of a subgroup go in step. Points are summed in a loop outside of that over nodes:
// where invocations that do not take part in a branch go through it all the same, none goes through
// points at nodes that are not opened.
vec3 beamSum(float sigma, float reachMm) {
  vec3 place = its.centroidArea.xyz;
  uint own = ranges[receiver].node;
  vec3 sum = vec3(0.0);
  uint end = min(body.clusters.y, endNode);
  uint next = linearIndex() < clusterCount && body.clusters.x < end ? body.clusters.x : noNode;
  uint last = noNode;
  uint cluster = 0u;
  while (true) {
    uint at;
    while (true) {
      at = subgroupMin(next);
      if (at == noNode || at == last) break;
      last = at;
      if (next == at) {
        BeamNode node = readBeamNode(at);
        uint link = floatBitsToUint(node.greenLink.w);
        vec3 squared = squaredDistances(BeamPoint(node.redRadius, node.greenLink, node.blueSquare), place);
        float nearest = leastOf(squared);
        float reached = reachMm + 2.0 * sqrt(node.blueSquare.w);
        bool taken = node.power.rgb == vec3(0.0) || nearest > reached * reached ||
                     afterNode(at, link) <= firstNode;
        // The receiver's own is always opened: part of it is in ownDiscs.
        if (!taken && at != own && isFar(nearest, node.redRadius.w, sigma, openingAngle)) {
          if (at >= firstNode) sum += fromNode(node, squared);
          taken = true;
        }
        cluster = firstSurfelOf(link);
        if (taken || !isLeaf(link)) next = taken ? afterNode(at, link) : at + 1u;
        if (next >= end) next = noNode;
      }
    }
    if (at == noNode) break;
    // Those that are still there have it too near to be taken.
    if (next == at) {
      sum += fromPoints(cluster);
      next = at + 1u < end ? at + 1u : noNode;
    }
  }
  return sum;
}

void putSum(vec3 sum) {
  uint i = linearIndex();
  if (i >= clusterCount) return;
  if (ranges[i].hasInside == 0u) sum = vec3(0.0);
  sums[i] = vec4(adds != 0u ? sums[i].rgb + sum : sum, 0.0);
}

#endif
