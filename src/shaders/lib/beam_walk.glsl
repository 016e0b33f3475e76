// The way through the tree of clusters with the points of light below them. Needs, before it,
// BINDING_BEAM_NODES and what lib/beam.glsl needs, and, after it, two functions:
//   vec3 fromNode(BeamNode node, vec3 squared)  light of all below a node
//   vec3 fromPoints(uint cluster)               light of a cluster's points, one by one
#ifndef OPALINE_LIB_BEAM_WALK
#define OPALINE_LIB_BEAM_WALK
#include "lib/beam.glsl"

layout(set = 0, binding = BINDING_BEAM_NODES) uniform samplerBuffer beamNodes;  // BeamNode

BeamNode readBeamNode(uint index) {
  int first = 4 * int(index);
  return BeamNode(texelFetch(beamNodes, first), texelFetch(beamNodes, first + 1),
                  texelFetch(beamNodes, first + 2), texelFetch(beamNodes, first + 3));
}

vec3 fromNode(BeamNode node, vec3 squared);
vec3 fromPoints(uint cluster);

// `reachMm` is where no light of any comes from further; the invocations of a subgroup go in step.
vec3 beamSum(vec3 place, uint root, uint end, float sigma, float reachMm, float openingAngle) {
  vec3 sum = vec3(0.0);
  uint next = root;
  while (true) {
    uint at = subgroupMin(next);
    if (at == noNode) break;
    if (next == at) {
      BeamNode node = readBeamNode(at);
      uint link = floatBitsToUint(node.greenLink.w);
      vec3 squared = squaredDistances(BeamPoint(node.redRadius, node.greenLink, node.blueSquare), place);
      float nearest = leastOf(squared);
      float reached = reachMm + 2.0 * sqrt(node.blueSquare.w);
      bool taken = node.power.rgb == vec3(0.0) || nearest > reached * reached;
      if (!taken && isFar(nearest, node.redRadius.w, sigma, openingAngle)) {
        sum += fromNode(node, squared);
        taken = true;
      }
      if (!taken && isLeaf(link)) {
        sum += fromPoints(firstSurfelOf(link));
        taken = true;
      }
      next = taken ? afterNode(at, link) : at + 1u;
      if (next >= end) next = noNode;
    }
  }
  return sum;
}

#endif
