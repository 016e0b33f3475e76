// The nodes that act on a tile of clusters: leaves, and nodes that are far from all of its clusters.
// Needs, before it, BINDING_CLUSTER_NODES and what lib/cluster_tile.glsl needs.
#ifndef OPALINE_LIB_CLUSTER_WALK
#define OPALINE_LIB_CLUSTER_WALK
#include "lib/cluster_node.glsl"
#include "lib/cluster_tile.glsl"

float nearestOnWalk;  // squared distance of the node found last to the tile's clusters, mm²

// The next node of this invocation's slice, from `at` on, that acts on the tile, or noNode.
uint nextOnWalk(inout uint at, float openingAngle) {
  uint found = noNode;
  while (found == noNode && at < sliceEnd) {
    vec4 centroidLink = centroidLinkOf(at);
    uint link = floatBitsToUint(centroidLink.w);
    uint after = afterNode(at, link);
    bool before = after <= sliceBegin;
    nearestOnWalk = nearestSquared(centroidLink.xyz);
    bool taken = isLeaf(link) || isFar(nearestOnWalk, spreadOf(at).x, leastSigma, openingAngle);
    if (taken && at >= sliceBegin) found = at;
    at = before || taken ? after : at + 1u;
  }
  return found;
}

#endif
