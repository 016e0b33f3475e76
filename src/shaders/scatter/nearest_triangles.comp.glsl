// What scatter/surface.vert.glsl and its fragments do, for triangles drawn by invocations and for all samples at once.
// First comes how near the nearest triangle is at each sample, as a number of which the largest is the nearest; then
// the first of the triangles that are that near. 0 means that there is none.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "lib/frame.glsl"
#include "lib/sample_words.glsl"

layout(std430, set = 0, binding = 3) buffer Depths { uint depths[]; };
layout(std430, set = 0, binding = 4) buffer Triangles { uint triangles[]; };

layout(push_constant) uniform Push {
  uint width;
  uint height;
  uint samples;
  uint triangleCount;
  uint rowsOfBand;
  uint findsTriangles;  // 1: depths are known
};

#include "lib/raster.glsl"

vec2 sampleAt(uint which) {
  return samples == 1u ? vec2(0.0) : frame.samples[which].xy;  // the frame may have those of another picture
}

void meet(uint triangle, ivec2 pixel, uint which, float depth) {
  uint at = placeOfSample(uvec2(pixel), which, width, samples);
  if (findsTriangles == 0u)
    atomicMax(depths[at], floatBitsToUint(depth));
  else if (depths[at] == floatBitsToUint(depth))
    atomicMax(triangles[at], wordOfTriangle(triangle));
}

void main() {
  drawTriangles(triangleCount, frame.worldToClip, Picture(ivec2(width, height), samples, rowsOfBand));
}
