// The share of the solid angle that the body fills around each cluster: c_i = Σ (x_j - x_i)·A_j /
// (4π r³), over the same nodes as the product takes.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#include "lib/boundary.glsl"
#include "lib/linear.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 3) buffer Clusters { Cluster clusters[]; };
layout(set = 0, binding = 4) uniform samplerBuffer nodes;  // ClusterNode

const float leastShare = 0.05;

layout(push_constant) uniform Push {
  uint clusterCount;
  float openingAngle;
};

void main() {
  uint i = linearIndex();
  bool inside = i < clusterCount;
  ClusterRange range = ranges[inside ? i : 0u];
  ObjectData body = objects[range.object];
  float sigma = leastOf(media[body.table.x].inside.sigma.rgb);
  vec3 place = clusters[inside ? i : 0u].centroidArea.xyz;
  float share = 0.0;
  uint next = inside ? body.clusters.x : noNode;
  while (true) {
    uint at = subgroupMin(next);
    if (at == noNode) break;
    if (next == at) {
      vec4 centroidLink = texelFetch(nodes, 3 * int(at));
      uint link = floatBitsToUint(centroidLink.w);
      vec3 offset = centroidLink.xyz - place;
      float squared = dot(offset, offset);
      bool taken = isLeaf(link) ||
                   isFar(squared, texelFetch(nodes, 3 * int(at) + 1).x, sigma, openingAngle);
      if (taken && at != range.node && squared > 0.0) {
        float over = inversesqrt(squared);
        float fills = over * over * over * dot(offset, texelFetch(nodes, 3 * int(at) + 2).xyz);
        if (isLeaf(link)) fills *= coverageOfDisc(squared, texelFetch(nodes, 3 * int(at) + 1).w);
        share += fills;
      }
      next = taken ? afterNode(at, link) : at + 1u;
      if (next >= body.clusters.y) next = noNode;
    }
  }
  // Clusters that lie upon each other might give any number.
  if (inside) clusters[i].vectorArea.w = clamp(share / (4.0 * pi), leastShare, 1.0);
}
