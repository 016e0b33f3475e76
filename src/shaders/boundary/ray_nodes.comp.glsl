// The boxes of inner nodes around those of their children.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_TREELETS 0
#include "lib/treelets.glsl"
#include "shared/rays.h"

layout(std430, set = 0, binding = 4) coherent buffer RayBoxes { RayBox boxes[]; };

layout(push_constant) uniform Push {
  uint firstTreelet;
  uint treeletCount;
  uint piecesPerSurfel;
};

void fitNode(uint node, uint link) {
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

void main() {
  fitTreelets(firstTreelet, treeletCount);
}
