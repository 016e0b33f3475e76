// The boxes of inner nodes, all of one height, around those of their children.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"
#include "lib/tree_node.glsl"
#include "shared/rays.h"

layout(std430, set = 0, binding = 0) readonly buffer Links { uint links[]; };
layout(std430, set = 0, binding = 1) readonly buffer ByHeight { uint byHeight[]; };
layout(std430, set = 0, binding = 2) buffer RayBoxes { RayBox boxes[]; };

layout(push_constant) uniform Push {
  uint first;
  uint count;
  uint piecesPerSurfel;
};

void main() {
  uint i = linearIndex();
  if (i >= count) return;
  uint node = byHeight[first + i];
  uint link = links[node];
  uint end = afterNode(node, link);
  vec3 low = boxes[node + 1u].lowLink.xyz;
  vec3 high = boxes[node + 1u].highPieces.xyz;
  for (uint child = node + 1u; child < end; child = afterNode(child, links[child])) {
    low = min(low, boxes[child].lowLink.xyz);
    high = max(high, boxes[child].highPieces.xyz);
  }
  boxes[node] =
      RayBox(vec4(low, uintBitsToFloat(link)), vec4(high, float(piecesPerSurfel)));
}
