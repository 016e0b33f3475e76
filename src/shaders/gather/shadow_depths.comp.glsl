// What gather/shadow.vert.glsl does, for triangles drawn by invocations: depths of some shadow views, one map after the
// other, as numbers of which the largest is the nearest.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "lib/frame.glsl"

layout(std430, set = 0, binding = 3) buffer Depths { uint depths[]; };

layout(push_constant) uniform Push {
  uint triangleCount;
  uint firstView;
  uint rowsOfBand;
};

#include "lib/raster.glsl"

vec2 sampleAt(uint which) {
  return vec2(0.0);
}

void meet(uint triangle, ivec2 pixel, uint which, float depth) {
  uint size = frame.counts.y;
  atomicMax(depths[(gl_WorkGroupID.z * size + uint(pixel.y)) * size + uint(pixel.x)], floatBitsToUint(depth));
}

void main() {
  drawTriangles(triangleCount, frame.shadowViews[firstView + gl_WorkGroupID.z], Picture(ivec2(frame.counts.y), 1u, rowsOfBand));
}
