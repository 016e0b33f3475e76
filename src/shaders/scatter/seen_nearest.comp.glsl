// Lists pixels whose samples see several triangles, from samples that scatter/nearest_triangles.comp.glsl has drawn.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_MIXED 1
#include "lib/mixed.glsl"
#include "lib/sample_words.glsl"
#include "lib/tile.glsl"

layout(set = 0, binding = 0, r32ui) writeonly uniform uimage2DArray words;
layout(std430, set = 0, binding = 3) readonly buffer Triangles { uint triangles[]; };

layout(push_constant) uniform Push {
  uint samples;
  uint firstRow;
};

uint drawnAt(ivec2 pixel, uint which) {
  return triangleOfWord(triangles[placeOfSample(uvec2(pixel), which, uint(imageSize(words).x), samples)]);
}

#include "lib/seen_at_once.glsl"

void main() { putSeen(imageSize(words).xy); }
