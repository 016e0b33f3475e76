// The share of the sky's irradiance that enters at a place, interpolated between clusters. Needs, before
// it, BINDING_CLUSTER_NODES, BINDING_CLUSTERS and BINDING_SKY_SHARES.
#ifndef OPALINE_LIB_SKY_SHARE
#define OPALINE_LIB_SKY_SHARE
#include "lib/cluster_node.glsl"
#include "lib/cluster_weight.glsl"
#include "lib/tree_node.glsl"

layout(std430, set = 0, binding = BINDING_CLUSTERS) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = BINDING_SKY_SHARES) readonly buffer SkyShares { vec4 skyShares[]; };

vec3 skyShareAt(vec3 place, vec3 normal, ObjectData body) {
  vec3 sum = vec3(0.0);
  float all = 0.0;
  uint node = body.clusters.x;
  while (node < body.clusters.y) {
    vec4 centroidLink = centroidLinkOf(node);
    uint link = floatBitsToUint(centroidLink.w);
    float reach = spreadOf(node).z;
    vec3 offset = centroidLink.xyz - place;
    float squared = dot(offset, offset);
    bool apart = squared >= reach * reach;
    if (!apart && isLeaf(link)) {
      uint i = firstSurfelOf(link);
      float weight = weightOfCluster(squared, reach, edgeOf(clusters[i]),
                                     dot(normal, clusters[i].normal.xyz)) * skyShares[i].w;
      sum += weight * skyShares[i].rgb;
      all += weight;
    }
    node = apart ? afterNode(node, link) : node + 1u;
  }
  return all > 0.0 ? sum / all : vec3(1.0);
}

#endif
