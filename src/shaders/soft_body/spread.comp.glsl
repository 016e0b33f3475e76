// Spreads the motion of the cage's nodes over a full grid around it, carried on beyond them.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"
#include "shared/soft_body.h"

struct Part {
  uint node;
  float weight;
};

layout(std430, set = 0, binding = 0) readonly buffer Motions { SoftMotion motions[]; };
layout(std430, set = 0, binding = 1) readonly buffer FirstPart { uint firstPart[]; };
layout(std430, set = 0, binding = 2) readonly buffer Parts { Part parts[]; };
layout(std430, set = 0, binding = 3) writeonly buffer Grid { vec4 grid[]; };  // xyz: cells

layout(push_constant) uniform Push { uint count; };

void main() {
  uint g = linearIndex();
  if (g >= count) return;
  vec3 shift = vec3(0.0);
  for (uint i = firstPart[g]; i < firstPart[g + 1u]; ++i) {
    SoftMotion motion = motions[parts[i].node];
    shift += parts[i].weight * vec3(motion.shiftX, motion.shiftY, motion.shiftZ);
  }
  grid[g] = vec4(shift, 0.0);
}
