// Nodes of the tree of clusters (shared/boundary.h), read as texels. Needs, before it,
// BINDING_CLUSTER_NODES.
#ifndef OPALINE_LIB_CLUSTER_NODE
#define OPALINE_LIB_CLUSTER_NODE
#include "lib/moment.glsl"
#include "lib/tree_node.glsl"
#include "shared/boundary.h"

layout(set = 0, binding = BINDING_CLUSTER_NODES) uniform samplerBuffer clusterNodes;  // ClusterNode

vec4 centroidLinkOf(uint node) {
  return texelFetch(clusterNodes, 5 * int(node));
}

vec4 spreadOf(uint node) {
  return texelFetch(clusterNodes, 5 * int(node) + 1);
}

vec3 vectorAreaOf(uint node) {
  return texelFetch(clusterNodes, 5 * int(node) + 2).xyz;
}

Moment momentOf(uint node) {
  return Moment(texelFetch(clusterNodes, 5 * int(node) + 3),
                texelFetch(clusterNodes, 5 * int(node) + 4).xy);
}

#endif
