// Means over the clusters around one. Needs, before it, BINDING_CLUSTER_NODES, BINDING_RANGES, BINDING_CLUSTERS and
// BINDING_AROUND, and somewhere powerOf().
#ifndef OPALINE_LIB_AROUND_CLUSTER
#define OPALINE_LIB_AROUND_CLUSTER
#include "lib/cluster_node.glsl"
#include "lib/cluster_weight.glsl"

layout(std430, set = 0, binding = BINDING_RANGES) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = BINDING_CLUSTERS) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = BINDING_AROUND) readonly buffer AroundTiles { uint around[]; };

// What is spread around.
vec3 powerOf(uint cluster);

// The mean of that over the areas. A cluster counts by what lies between their middles, their normals, and how far it
// is felt.
vec3 meanAround(uint i) {
  vec3 place = clusters[i].centroidArea.xyz;
  vec3 normal = clusters[i].normal.xyz;
  vec3 sum = vec3(0.0);
  float area = 0.0;
  uint list = ranges[i].tile * roomOfAround;
  uint end = list + 1u + around[list];
  for (uint at = list + 1u; at < end; ++at) {
    uint leaf = around[at];
    uint j = firstSurfelOf(floatBitsToUint(centroidLinkOf(leaf).w));
    vec3 offset = clusters[j].centroidArea.xyz - place;
    float reach = spreadOf(leaf).z;
    float near = max(1.0 - dot(offset, offset) / max(reach * reach, 1e-30), 0.0);
    float weight = near * max(dot(normal, clusters[j].normal.xyz), leastFacing);
    sum += weight * powerOf(j);
    area += weight * clusters[j].centroidArea.w;
  }
  return sum / max(area, 1e-30);
}

#endif
