// How much of what 2×2 pixels mirror is sky, where one smooth surface fills them. Where that fills a block of
// 4×4 pixels and rays from its corners agree, all of it is as they say. Else its quarters are asked from
// opposite corners, by the widest rays of the lobe. Where even 2×2 pixels disagree and the lobe is wide, so
// that its shadows are soft, they share twice the rays of one.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define MESH_BINDING 7
#define BINDING_OBJECTS 2
#define BINDING_PIECE_CORNERS 3
#define BINDING_RAYS 4
#define BINDING_MEDIA 6
#include "lib/material.glsl"
#include "lib/frame.glsl"
#include "lib/seen.glsl"
#include "lib/sky_block.glsl"
#include "lib/sky_rays.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 5, r32f) writeonly uniform image2D skyBlocks;

// Of the lobe, from which on pixels need not tell apart what they mirror.
const float leastAlphaShared = 0.04;

// Some translucent surfaces have a roughness or normals of their own, and are not smooth.
layout(constant_id = 0) const uint withOwnSurfaces = 0u;

// Between two corners' normals: what turns further may mirror other things between them.
const float leastCosine = 0.97;

// A work group has a square of so many of the smallest blocks, known by their Morton numbers: the quarters
// of a block are four that follow each other.
const uint widthOfGroup = 16u;
const uint smallest = widthOfGroup * widthOfGroup;
const uint levels = 2u;  // 4×4 and 2×2 pixels

shared bool broken[levels][smallest];  // no single surface fills the block
shared uint asked[levels + 1u][smallest];  // blocks of each level, then those that disagree to the last
shared uint askedCount[levels + 1u];
// Of each block on a list, a bit for each kind of ray; then how many went, and above 16 bits how many are free.
shared uint answers[smallest];
shared float shares[smallest];  // of the smallest blocks, or unknownShare

uvec2 placeOfMorton(uint i) {
  uvec2 place = uvec2(0u);
  for (int bit = 0; bit < 4; ++bit)
    place |= uvec2(bitfieldExtract(i, 2 * bit, 1), bitfieldExtract(i, 2 * bit + 1, 1)) << bit;
  return place;
}

ivec2 firstPixel() {
  return 2 * ivec2(gl_WorkGroupID.xy * widthOfGroup) + ivec2(0, first);
}

bool isFilled(ivec2 corner) {
  if (any(greaterThanEqual(corner + 1, textureSize(seenWords, 0).xy))) return false;
  for (int i = 0; i < 4; ++i)
    if (samplesOf(seenWord(corner + ivec2(i & 1, i >> 1), 0u)) != everySample) return false;
  return true;
}

MeshPlace placeSeenAt(ivec2 pixel) {
  return seenPlace(pixel, seenWord(pixel, 0u));
}

ivec2 cornerOf(uint corner) {
  return ivec2(corner & 1u, corner >> 1u);
}

ivec2 pixelOfBlock(uint firstBelow) {
  return firstPixel() + 2 * ivec2(placeOfMorton(firstBelow));
}

// From one of the block's corners, if the surface goes on smoothly to the one opposite.
uint rayFromCorner(ivec2 pixel, int width, uint corner) {
  MeshPlace here = placeSeenAt(pixel + (width - 1) * cornerOf(corner));
  MeshPlace there = placeSeenAt(pixel + (width - 1) * cornerOf(3u - corner));
  if (here.object != there.object || dot(here.normal, there.normal) < leastCosine) return noRay;
  if (withOwnSurfaces != 0u && hasOwnSurface(mediumAt(objects[here.object], here.position))) return noRay;
  const uint order[4] = uint[4](0u, 2u, 3u, 1u);  // opposite corners follow each other
  uint raysInAll = raysOfSample(alpha) * samples;
  uint widest = raysInAll - 1u;
  return reflectedRay(widest - min(order[corner], widest), raysInAll, here, Mirror(alpha, here.normal));
}

void findBroken() {
  uint i = gl_LocalInvocationIndex;
  for (uint level = 0u; level < levels; ++level)
    for (uint k = i; k < smallest; k += gl_WorkGroupSize.x) broken[level][k] = false;
  barrier();
  for (uint k = i; k < smallest; k += gl_WorkGroupSize.x) {
    shares[k] = unknownShare;
    if (isFilled(pixelOfBlock(k))) continue;
    for (uint level = 0u; level < levels; ++level) broken[level][k >> 2u * (levels - 1u - level)] = true;
  }
}

void putOnList(uint block, uint list) {
  asked[list][atomicAdd(askedCount[list], 1u)] = block;
}

void askQuarters(uint block, uint levelOfQuarters) {
  for (uint quarter = 4u * block; quarter < 4u * block + 4u; ++quarter)
    if (!broken[levelOfQuarters][quarter]) putOnList(quarter, levelOfQuarters);
}

// Asks the blocks of a level. What is known then is put down for the smallest below; those of the smallest
// that disagree are left to be asked again, and of others the quarters.
void ask(uint level) {
  uint count = askedCount[level];
  uint apart = max(count, 1u);
  uint rays = level == 0u ? 4u : 2u;
  int width = int(1u << levels - level);
  uint shift = 2u * (levels - 1u - level);  // from a block's number to that of the first of the smallest in it
  for (uint k = gl_LocalInvocationIndex; k < count; k += gl_WorkGroupSize.x) answers[k] = 0u;
  barrier();
  for (uint k = gl_LocalInvocationIndex; k < rays * count; k += gl_WorkGroupSize.x) {
    // Rays side by side are alike, so that they take the same way.
    uint block = asked[level][k % apart];
    uint corner = level == 0u ? k / apart : 3u * (k / apart);
    atomicOr(answers[k % apart], 1u << rayFromCorner(pixelOfBlock(block << shift), width, corner));
  }
  barrier();
  for (uint k = gl_LocalInvocationIndex; k < count; k += gl_WorkGroupSize.x) {
    uint block = asked[level][k];
    bool allMeet = answers[k] == 1u << rayMeets;
    bool allFree = answers[k] == 1u << rayIsFree;
    bool disagrees = answers[k] == (1u << rayMeets | 1u << rayIsFree);
    if (allMeet || allFree) {
      for (uint small = block << shift; small < block + 1u << shift; ++small) shares[small] = allFree ? 1.0 : 0.0;
    } else if (level < levels - 1u) {
      askQuarters(block, level + 1u);
    } else if (disagrees) {
      putOnList(block, levels);
    }
  }
  barrier();
}

// Rays of the lobe from the smallest blocks that are left, each pixel half of what it would send alone.
void askDisagreeing() {
  uint count = askedCount[levels];
  uint apart = max(count, 1u);
  uint rays = 2u * raysOfSample(alpha) * samples;
  for (uint k = gl_LocalInvocationIndex; k < count; k += gl_WorkGroupSize.x) answers[k] = 0u;
  barrier();
  for (uint k = gl_LocalInvocationIndex; k < rays * count; k += gl_WorkGroupSize.x) {
    uint i = k / apart;
    MeshPlace place = placeSeenAt(pixelOfBlock(asked[levels][k % apart]) + cornerOf(i % 4u));
    uint ray = reflectedRay(i, rays, place, Mirror(alpha, place.normal));
    if (ray != noRay) atomicAdd(answers[k % apart], 1u + (ray << 16u));
  }
  barrier();
  for (uint k = gl_LocalInvocationIndex; k < count; k += gl_WorkGroupSize.x)
    shares[asked[levels][k]] = float(answers[k] >> 16u) / float(max(answers[k] & 0xffffu, 1u));
}

void main() {
  if (gl_LocalInvocationIndex <= levels) askedCount[gl_LocalInvocationIndex] = 0u;
  findBroken();
  barrier();
  const uint largest = smallest >> 2u * (levels - 1u);
  uint mine = gl_LocalInvocationIndex;
  if (mine < largest && !broken[0][mine]) putOnList(mine, 0u);
  if (mine < largest && broken[0][mine]) askQuarters(mine, 1u);
  barrier();
  for (uint level = 0u; level < levels; ++level) ask(level);
  if (alpha >= leastAlphaShared) askDisagreeing();
  barrier();
  for (uint k = gl_LocalInvocationIndex; k < smallest; k += gl_WorkGroupSize.x) {
    ivec2 block = pixelOfBlock(k) / 2;
    if (all(lessThan(block, imageSize(skyBlocks)))) imageStore(skyBlocks, block, vec4(shares[k]));
  }
}
