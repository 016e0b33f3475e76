// What seen.comp.glsl does, of samples that were drawn at once. A pixel's first word without a surface ends them.
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

void main() {
  ivec2 pixel = pixelOfInvocation() + ivec2(0, firstRow);
  ivec2 size = textureSize(drawn);
  bool inside = all(lessThan(pixel, size));
  ivec2 within = min(pixel, size - 1);
  uint triangle = texelFetch(drawn, within, 0).r;
  bool several = false;
  for (int i = 1; i < int(samples); ++i) several = several || texelFetch(drawn, within, i).r != triangle;
  several = several && inside;
  uint word = !several && triangle != 0u ? triangle | everySample << seenSamplesShift : triangle;
  if (inside) imageStore(words, ivec3(pixel, 0), uvec4(word));
  if (inside) imageStore(words, ivec3(pixel, 1), uvec4(several ? texelFetch(drawn, within, 1).r : 0u));
  for (int i = 2; several && i < int(samples); ++i)
    imageStore(words, ivec3(pixel, i), uvec4(texelFetch(drawn, within, i).r));
  listMixed(several, uint(pixel.y * size.x + pixel.x));
}
