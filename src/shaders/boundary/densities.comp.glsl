// A fluence at the clusters as densities on their nodes: at leaves, one a cluster, or at inner nodes
// of one height.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 7
#define BINDING_MEDIA 8
#include "lib/boundary.glsl"
#include "lib/linear.glsl"
#include "lib/solver.glsl"

layout(constant_id = 0) const uint ofLeaves = 1u;

layout(std430, set = 0, binding = 0) readonly buffer Links { uint links[]; };
layout(std430, set = 0, binding = 1) readonly buffer ByHeight { uint byHeight[]; };
layout(std430, set = 0, binding = 2) buffer Nodes { DensityNode nodes[]; };
layout(std430, set = 0, binding = 3) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 4) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 5) readonly buffer Fluences { vec4 fluences[]; };
layout(std430, set = 0, binding = 6) readonly buffer States { SolverState states[]; };

layout(std430, set = 0, binding = 9) readonly buffer Shapes { ClusterNode shapes[]; };

layout(push_constant) uniform Push {
  uint first;  // of the nodes by height, or of the fluences
  uint count;
  uint step;  // of the solver; skipped when that is done
  uint solution;
};

// Seen from another place, a density is one there and a dipole.
vec4 moved(vec4 density, vec3 offset) {
  return vec4(density.xyz + density.w * offset, density.w);
}

void main() {
  uint i = linearIndex();
  if (i >= count || step > 0u && states[solution].done[doneBefore(step)] != 0u) return;
  if (ofLeaves != 0u) {
    vec4 shape = vec4(clusters[i].vectorArea.xyz, clusters[i].centroidArea.w);
    vec3 fluence = fluences[first + i].rgb;
    nodes[ranges[i].node] = DensityNode(fluence.r * shape, fluence.g * shape, fluence.b * shape);
    return;
  }
  uint node = byHeight[first + i];
  uint end = afterNode(node, links[node]);
  BoundaryMedium medium = insideOf(objects[uint(shapes[node].vectorArea.w)]);
  vec3 weightS = 1.0 / (2.0 * medium.diffusion.w * medium.diffusion.rgb);
  vec3 place = shapes[node].centroidLink.xyz;
  DensityNode sum = DensityNode(vec4(0.0), vec4(0.0), vec4(0.0));
  for (uint child = node + 1u; child < end; child = afterNode(child, links[child])) {
    vec3 offset = shapes[child].centroidLink.xyz - place;
    sum.red += moved(nodes[child].red, weightS.r * offset);
    sum.green += moved(nodes[child].green, weightS.g * offset);
    sum.blue += moved(nodes[child].blue, weightS.b * offset);
  }
  nodes[node] = sum;
}
