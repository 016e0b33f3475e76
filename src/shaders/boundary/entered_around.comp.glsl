// Adds light that enters again and comes from afar, as a mean over the clusters around. The few rays of a cluster meet
// what is small and bright, like a patch of lit floor, more or less often by chance; those of the clusters beside it
// make up for that.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_CLUSTER_NODES 2
#define BINDING_RANGES 3
#define BINDING_CLUSTERS 4
#define BINDING_AROUND 5
#define BINDING_CLUSTER_PAINTS 9
#include "lib/around_cluster.glsl"
#include "lib/diffuse_power.glsl"
#include "lib/linear.glsl"

layout(std430, set = 0, binding = 6) readonly buffer FromAfar { vec4 fromAfar[]; };
layout(std430, set = 0, binding = 7) buffer Entered { vec4 entered[]; };
layout(std430, set = 0, binding = 8) buffer Strengths { vec4 strengths[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
};

vec3 powerOf(uint cluster) {
  return clusters[cluster].centroidArea.w * fromAfar[cluster].rgb;
}

void main() {
  uint i = linearIndex();
  if (i >= clusterCount) return;
  Cluster cluster = clusters[i];
  vec3 all = entered[i].rgb + (boundsDiffusion(ranges[i].kind) ? meanAround(i) : fromAfar[i].rgb);
  entered[i] = vec4(all, 0.0);
  strengths[i].rgb = diffusePower(i, cluster, insideOf(objects[ranges[i].object]), all);
}
