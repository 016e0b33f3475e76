// A fluence at the clusters as densities on their nodes: at leaves, one a cluster, or at inner nodes
// of one height.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"
#include "lib/tree_node.glsl"
#include "shared/boundary.h"

layout(constant_id = 0) const uint ofLeaves = 1u;

layout(std430, set = 0, binding = 0) readonly buffer Links { uint links[]; };
layout(std430, set = 0, binding = 1) readonly buffer ByHeight { uint byHeight[]; };
layout(std430, set = 0, binding = 2) buffer Nodes { DensityNode nodes[]; };
layout(std430, set = 0, binding = 3) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 4) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 5) readonly buffer Fluences { vec4 fluences[]; };
layout(std430, set = 0, binding = 6) readonly buffer State { SolverState state; };

layout(push_constant) uniform Push {
  uint first;  // of the nodes by height, or of the fluences
  uint count;
  uint step;  // of the solver; skipped when that is done
};

void main() {
  uint i = linearIndex();
  if (i >= count || step > 0u && state.done != 0u) return;
  if (ofLeaves != 0u) {
    vec4 shape = vec4(clusters[i].vectorArea.xyz, clusters[i].centroidArea.w);
    vec3 fluence = fluences[first + i].rgb;
    nodes[ranges[i].node] = DensityNode(fluence.r * shape, fluence.g * shape, fluence.b * shape);
    return;
  }
  uint node = byHeight[first + i];
  uint end = afterNode(node, links[node]);
  DensityNode sum = DensityNode(vec4(0.0), vec4(0.0), vec4(0.0));
  for (uint child = node + 1u; child < end; child = afterNode(child, links[child])) {
    sum.red += nodes[child].red;
    sum.green += nodes[child].green;
    sum.blue += nodes[child].blue;
  }
  nodes[node] = sum;
}
