// Lists the pixels of a band whose samples see several triangles. Other pixels that see anything get the word of their
// surface.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_MIXED 1
#include "lib/mixed.glsl"
#include "lib/tile.glsl"

layout(set = 0, binding = 0, r32ui) uniform uimage2DArray words;  // the samples' triangles, plus one

layout(push_constant) uniform Push {
  uint samples;
  uint firstRow;
};

void main() {
  ivec2 pixel = pixelOfInvocation() + ivec2(0, firstRow);
  ivec2 size = imageSize(words).xy;
  bool inside = all(lessThan(pixel, size));
  uint index = uint(pixel.y * size.x + pixel.x);
  uint triangle = inside ? imageLoad(words, ivec3(pixel, 0)).r : 0u;
  bool several = false;
  for (uint i = 1u; i < samples; ++i)
    several = several || inside && imageLoad(words, ivec3(pixel, i)).r != triangle;
  if (!several && triangle != 0u) imageStore(words, ivec3(pixel, 0), uvec4(triangle | everySample << seenSamplesShift));
  listMixed(several, index);
}
