// Nodes of points of light (shared/boundary.h), read as texels, and how they lie to the clusters they shine
// on. Needs BINDING_BEAM_NODES.
#ifndef OPALINE_LIB_BEAM_NODE
#define OPALINE_LIB_BEAM_NODE
#include "lib/texels.glsl"
#include "lib/tree_node.glsl"
#include "shared/boundary.h"

TEXELS(BINDING_BEAM_NODES, beamNodes);  // BeamNode

BeamNode readBeamNode(uint index) {
  int first = 6 * int(index);
  return BeamNode(texelOf(beamNodes, first), texelOf(beamNodes, first + 1),
                  texelOf(beamNodes, first + 2), texelOf(beamNodes, first + 3),
                  texelOf(beamNodes, first + 4), texelOf(beamNodes, first + 5));
}

uint linkOf(BeamNode node) {
  return floatBitsToUint(node.greenLink.w);
}

// The cluster whose points a leaf has; any for other nodes.
uint clusterOf(BeamNode node) {
  return isLeaf(linkOf(node)) ? firstSurfelOf(linkOf(node)) : 0u;
}

vec3 powerOf(BeamNode node) {
  return vec3(node.redPower.w, node.extent.w, node.bluePower.w);
}

// A sphere that holds some clusters.
struct Around {
  vec3 middle;
  float radius;
};

// No centroid lies nearer than this to the sphere's middle.
float leastDistance(BeamNode node, Around around) {
  return distance(node.greenLink.xyz, around.middle) - node.extent.y;
}

// No centroid lies nearer than this to a cluster.
float nearestOf(BeamNode node, Around around) {
  return max(leastDistance(node, around) - around.radius, 0.0);
}

// The nodes that act on the clusters of a group, as a list: how many, and then which. The points of a
// marked node are taken one by one unless it is far from the tile.
const uint openedBit = 1u << 31u;

uint startOfList(uint group, uint room) {
  return group * (room + 1u);
}

#endif
