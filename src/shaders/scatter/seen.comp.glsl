// Lists, in any order, the pixels of a band whose samples see several triangles. Others that see anything get the word of
// their surface.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "lib/groups.glsl"
#include "lib/tile.glsl"
#include "shared/seen.h"

layout(set = 0, binding = 0, r32ui) uniform uimage2DArray words;  // the samples' triangles, plus one
layout(std430, set = 0, binding = 1) writeonly buffer Mixed { uint mixed[]; };
layout(std430, set = 0, binding = 2) buffer MixedCount { SeenCount mixedCount; };

layout(push_constant) uniform Push {
  uint samples;
  uint firstRow;
};

void listMixed(bool several, uint pixel) {
  uint added = several ? 1u : 0u;
  uint before = subgroupExclusiveAdd(added);
  uint all = subgroupAdd(added);
  uint start = 0u;
  if (subgroupElect() && all != 0u) {
    start = atomicAdd(mixedCount.groupsEntries.w, all);
    atomicMax(mixedCount.groupsEntries.x, groupsFor(start + all));
    atomicMax(mixedCount.groupsEntries.y, 1u);
    atomicMax(mixedCount.groupsEntries.z, 1u);
  }
  start = subgroupMax(start);
  if (several) mixed[start + before] = pixel;
}

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
