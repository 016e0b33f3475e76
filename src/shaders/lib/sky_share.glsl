// The share of the sky's irradiance that enters at a place, interpolated between clusters. Needs, before
// it, BINDING_CLUSTER_NODES, BINDING_CLUSTERS and BINDING_SKY_SHARES.
#ifndef OPALINE_LIB_SKY_SHARE
#define OPALINE_LIB_SKY_SHARE
#include "lib/clusters_around.glsl"

layout(std430, set = 0, binding = BINDING_SKY_SHARES) readonly buffer SkyShares { vec4 skyShares[]; };

vec3 skyShareAt(vec3 place, vec3 normal, ObjectData body) {
  vec3 sum = vec3(0.0);
  float all = 0.0;
  uint node = body.clusters.x;
  while (node < body.clusters.y) {
    uint i;
    float weight = weightOfNext(node, place, normal, i);
    if (weight <= 0.0) continue;
    weight *= skyShares[i].w;
    sum += weight * skyShares[i].rgb;
    all += weight;
  }
  return all > 0.0 ? sum / all : vec3(1.0);
}

#endif
