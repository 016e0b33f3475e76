// A walk over the clusters around a place. Needs, before it, BINDING_CLUSTER_NODES and
// BINDING_CLUSTERS.
#ifndef OPALINE_LIB_CLUSTERS_AROUND
#define OPALINE_LIB_CLUSTERS_AROUND
#include "lib/cluster_node.glsl"
#include "lib/cluster_weight.glsl"
#include "lib/tree_node.glsl"

layout(std430, set = 0, binding = BINDING_CLUSTERS) readonly buffer Clusters { Cluster clusters[]; };

// Looks at a node and goes on to the next. Returns how much the node's cluster counts at the place, 0 if it has none.
float weightOfNext(inout uint node, vec3 place, vec3 normal, out uint cluster) {
  vec4 centroidLink = centroidLinkOf(node);
  uint link = floatBitsToUint(centroidLink.w);
  float reach = spreadOf(node).z;
  vec3 offset = centroidLink.xyz - place;
  float squared = dot(offset, offset);
  bool apart = squared >= reach * reach;
  node = apart ? afterNode(node, link) : node + 1u;
  cluster = firstSurfelOf(link);
  if (apart || !isLeaf(link)) return 0.0;
  return weightOfCluster(squared, reach, edgeOf(clusters[cluster]), dot(normal, clusters[cluster].normal.xyz));
}

#endif
