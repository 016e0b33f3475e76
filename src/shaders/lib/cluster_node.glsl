// Nodes of the tree of clusters (shared/boundary.h), read as texels. Needs, before it,
// BINDING_CLUSTER_NODES.
#ifndef OPALINE_LIB_CLUSTER_NODE
#define OPALINE_LIB_CLUSTER_NODE
#include "lib/moment.glsl"
#include "lib/texels.glsl"
#include "lib/tree_node.glsl"
#include "shared/boundary.h"

TEXELS(BINDING_CLUSTER_NODES, clusterNodes);  // ClusterNode

vec4 centroidLinkOf(uint node) {
  return texelOf(clusterNodes, 5 * int(node));
}

vec4 spreadOf(uint node) {
  return texelOf(clusterNodes, 5 * int(node) + 1);
}

vec3 vectorAreaOf(uint node) {
  return texelOf(clusterNodes, 5 * int(node) + 2).xyz;
}

Moment momentOf(uint node) {
  return Moment(texelOf(clusterNodes, 5 * int(node) + 3),
                texelOf(clusterNodes, 5 * int(node) + 4).xy);
}

#endif
