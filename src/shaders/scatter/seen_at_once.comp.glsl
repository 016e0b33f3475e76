// Lists pixels whose samples see several triangles, from samples that hardware has drawn at once.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_MIXED 1
#include "lib/mixed.glsl"
#include "lib/tile.glsl"

layout(set = 0, binding = 0, r32ui) writeonly uniform uimage2DArray words;
layout(set = 0, binding = 3) uniform usampler2DMS drawn;  // the samples' triangles, plus one

layout(push_constant) uniform Push {
  uint samples;
  uint firstRow;
};

uint drawnAt(ivec2 pixel, uint which) {
  return texelFetch(drawn, pixel, int(which)).r;
}

#include "lib/seen_at_once.glsl"

void main() { putSeen(textureSize(drawn)); }
