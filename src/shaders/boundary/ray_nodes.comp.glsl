// The boxes of inner nodes around those of their children.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_TREELETS 0
#include "lib/ray_box.glsl"
#include "lib/treelets.glsl"

layout(std430, set = 0, binding = 4) coherent buffer RayBoxes {
  RayUnits units;
  RayBox ofNodes[];
} boxes;

layout(push_constant) uniform Push {
  uint firstTreelet;
  uint treeletCount;
};

void fitNode(uint node, uint link) {
  uint end = afterNode(node, link);
  mat2x3 sides = sidesOf(boxes.ofNodes[node + 1u]);
  for (uint child = afterNode(node + 1u, links[node + 1u]); child < end; child = afterNode(child, links[child])) {
    mat2x3 others = sidesOf(boxes.ofNodes[child]);
    sides = mat2x3(min(sides[0], others[0]), max(sides[1], others[1]));
  }
  boxes.ofNodes[node] = packedBox(sides[0], sides[1], link);
}

void main() {
  fitTreelets(firstTreelet, treeletCount);
}
