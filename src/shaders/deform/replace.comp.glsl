// Takes positions from the caller's buffer.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"

layout(std430, set = 0, binding = 0) readonly buffer Given { float given[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Replaced { float replaced[]; };

layout(push_constant) uniform Push {
  uint offset;  // in floats, as is the stride; the rest in vertices
  uint stride;
  uint first;
  uint count;
  vec4 origin;  // mm, of the scene as the device has it
};

void main() {
  uint i = linearIndex();
  if (i >= count) return;
  for (uint axis = 0u; axis < 3u; ++axis) replaced[3u * (first + i) + axis] = given[offset + i * stride + axis] - origin[axis];
}
