// The share of the solid angle that the body fills around each cluster: c_i = Σ (x_j - x_i)·A_j /
// (4π r³), over the same nodes as the product takes, with their first moments.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_CLUSTER_NODES 4
#include "lib/boundary.glsl"
#include "lib/cluster_node.glsl"
#include "lib/linear.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 3) buffer Clusters { Cluster clusters[]; };

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
  float sigma = leastOf(insideOf(body).sigma.rgb);
  vec3 place = clusters[inside ? i : 0u].centroidArea.xyz;
  float share = 0.0;
  uint next = inside ? body.clusters.x : noNode;
  while (true) {
    uint at = subgroupMin(next);
    if (at == noNode) break;
    if (next == at) {
      vec4 centroidLink = centroidLinkOf(at);
      uint link = floatBitsToUint(centroidLink.w);
      vec3 offset = centroidLink.xyz - place;
      float squared = dot(offset, offset);
      bool taken = isLeaf(link) ||
                   isFar(squared, spreadOf(at).x, sigma, openingAngle);
      if (taken && at != range.node && squared > leastSquaredMm2) {
        float over = inversesqrt(squared);
        float over3 = over * over * over;
        float fills = over3 * dot(offset, vectorAreaOf(at));
        if (isLeaf(link)) {
          fills *= coverageOfDisc(squared, spreadOf(at).w);
        } else {
          Moment moment = momentOf(at);
          fills += over3 * (traceOf(moment) - 3.0 * over * over * alongTwice(moment, offset));
        }
        share += fills;
      }
      next = taken ? afterNode(at, link) : at + 1u;
      if (next >= body.clusters.y) next = noNode;
    }
  }
  // Clusters that lie upon each other might give any number.
  if (inside) clusters[i].vectorArea.w = clamp(share / (4.0 * pi), leastShare, 1.0);
}
