// Lists the leaves of clusters that are felt anywhere in a tile, in the order of the tree.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_TILES 2
#define BINDING_CLUSTER_NODES 4
#include "lib/cluster_node.glsl"
#include "lib/cluster_tile.glsl"
#include "lib/group_place.glsl"

layout(std430, set = 0, binding = 5) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 6) writeonly buffer Around { uint around[]; };

layout(push_constant) uniform Push {
  uint tileCount;
};

float largestRadius() {
  float largest = 0.0;
  for (uint k = tile.firstCluster; k < tile.endCluster; ++k) largest = max(largest, spreadOf(ranges[k].node).x);
  return largest;
}

// Of this invocation's part of the tree, the next leaf from `at` on that is felt within so much of a cluster's middle.
uint nextFelt(inout uint at, float radius) {
  while (at < sliceEnd) {
    uint node = at;
    vec4 centroidLink = centroidLinkOf(node);
    uint link = floatBitsToUint(centroidLink.w);
    uint after = afterNode(node, link);
    float felt = spreadOf(node).z + radius;
    bool apart = after <= sliceBegin || nearestSquared(centroidLink.xyz) > felt * felt;
    at = apart || isLeaf(link) ? after : node + 1u;
    if (!apart && isLeaf(link) && node >= sliceBegin) return node;
  }
  return noNode;
}

void main() {
  if (!enterTile(tileCount)) return;
  float radius = largestRadius();
  uint count = 0u;
  uint at = body.clusters.x;
  while (nextFelt(at, radius) != noNode) ++count;
  uint all;
  uint place = groupPlaceFor(count, all);
  uint list = tileIndex * roomOfAround;
  if (gl_LocalInvocationIndex == 0u) around[list] = min(all, roomOfAround - 1u);
  at = body.clusters.x;
  for (; count > 0u && place < roomOfAround - 1u; --count) around[list + 1u + place++] = nextFelt(at, radius);
}
