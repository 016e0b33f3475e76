// Adds light that enters again and comes from afar, as a mean over the clusters around. The few rays of a cluster meet
// what is small and bright, like a patch of lit floor, more or less often by chance; those of the clusters beside it
// make up for that.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_CLUSTER_NODES 2
#define BINDING_CLUSTER_PAINTS 9
#include "lib/around_cluster.glsl"
#include "lib/cluster_node.glsl"
#include "lib/diffuse_power.glsl"
#include "lib/linear.glsl"

layout(std430, set = 0, binding = 3) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 4) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 5) readonly buffer AroundTiles { uint around[]; };
layout(std430, set = 0, binding = 6) readonly buffer FromAfar { vec4 fromAfar[]; };
layout(std430, set = 0, binding = 7) buffer Entered { vec4 entered[]; };
layout(std430, set = 0, binding = 8) buffer Strengths { vec4 strengths[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
};

vec3 meanAround(uint i, Cluster cluster) {
  vec3 sum = vec3(0.0);
  float area = 0.0;
  uint list = ranges[i].tile * roomOfAround;
  uint end = list + 1u + around[list];
  for (uint at = list + 1u; at < end; ++at) {
    uint leaf = around[at];
    uint j = firstSurfelOf(floatBitsToUint(centroidLinkOf(leaf).w));
    Cluster other = clusters[j];
    float weight = other.centroidArea.w * weightAround(other.centroidArea.xyz - cluster.centroidArea.xyz,
                                                       cluster.normal.xyz, other.normal.xyz, spreadOf(leaf).z);
    sum += weight * fromAfar[j].rgb;
    area += weight;
  }
  return area > 0.0 ? sum / area : fromAfar[i].rgb;
}

void main() {
  uint i = linearIndex();
  if (i >= clusterCount) return;
  Cluster cluster = clusters[i];
  vec3 all = entered[i].rgb + (boundsDiffusion(ranges[i].kind) ? meanAround(i, cluster) : fromAfar[i].rgb);
  entered[i] = vec4(all, 0.0);
  strengths[i].rgb = diffusePower(i, cluster, insideOf(objects[ranges[i].object]), all);
}
