// How much of what 2×2 pixels mirror is sky, where one smooth surface fills them. Where it fills a block of 4×4
// pixels and rays from the block's corners agree, they hold for all of it. Four blocks share a corner, and each
// block has a ray of each kind at its own. Otherwise its quarters are tested from opposite corners, by the widest
// rays of the lobe, and where these meet something by its middle. That tells of all four pixels even where one surface
// fills only the two that are asked. Where 2×2 pixels filled by it disagree and the lobe is wide, so that its shadows
// are soft, they share twice the rays of one.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define MESH_BINDING 7
#define BINDING_OBJECTS 2
#define BINDING_PIECE_CORNERS 3
#define BINDING_RAYS 4
#define BINDING_MEDIA 6
#include "lib/material.glsl"
#include "lib/morton.glsl"
#include "lib/frame.glsl"
#include "lib/seen.glsl"
#include "lib/sky_block.glsl"
#include "lib/sky_rays.glsl"
#include "lib/window_cell.glsl"

layout(local_size_x = 64, local_size_x_id = 19) in;

layout(set = 0, binding = 5, r32f) writeonly uniform image2D skyBlocks;

// Some translucent surfaces have a roughness or normals of their own, and are not smooth.
layout(constant_id = 0) const uint withOwnSurfaces = 0u;

// Least cosine between two corners' normals: surfaces that turn further may mirror other things between them.
const float leastCosine = 0.97;

// A work group has a square of the smallest blocks, this many across, known by their Morton numbers: the
// quarters of a block are four that follow each other.
const uint widthOfGroup = 16u;
const uint smallest = widthOfGroup * widthOfGroup;
const uint levels = 2u;  // 4×4 and 2×2 pixels

shared bool broken[levels][smallest];  // no single surface fills the block
shared bool spanned[smallest];  // single surfaces fill two opposite pixels of the block
shared uint asked[levels + 1u][smallest];  // blocks of each level, and last those that disagree to the end
shared uint askedCount[levels + 1u];
// For each block on a list, a bit for each kind of answer; later how many rays went, and above 16 bits how many
// are free.
shared uint answers[smallest];
shared float shares[smallest];  // of the smallest blocks, or unknownShare

// The corners of the largest blocks of the group.
const uint widthOfCorners = widthOfGroup / 2u + 1u;
const uint corners = widthOfCorners * widthOfCorners;
const uint noObject = 0xffffffffu;
shared uint rayOfCorner[corners];
shared uint objectOfCorner[corners];  // noObject where no single surface fills the pixel
shared vec3 normalOfCorner[corners];

ivec2 firstPixel() {
  return 2 * ivec2(gl_WorkGroupID.xy * widthOfGroup) + ivec2(0, first);
}

bool isFilled(ivec2 pixel) {
  if (any(greaterThanEqual(pixel, textureSize(seenWords, 0).xy))) return false;
  return samplesOf(seenWord(pixel, 0u)) == everySample;
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

// Rays of four kinds are the widest of the lobe, one kind for each corner of a block. The fifth is its middle.
const uint inTheMiddle = 4u;

uint rayOfKind(uint kind, MeshPlace here) {
  if (withOwnSurfaces != 0u && hasOwnSurface(mediumAt(objects[here.object], here.position))) return noRay;
  const uint order[4] = uint[4](0u, 2u, 3u, 1u);  // those of opposite corners follow each other
  uint raysInAll = raysOfSample(alpha) * samples;
  uint widest = raysInAll - 1u;
  uint i = kind == inTheMiddle ? 0u : widest - min(order[kind], widest);
  return reflectedRay(i, raysInAll, here, Mirror(alpha, here.normal));
}

bool goesOnSmoothly(uint objectHere, vec3 normalHere, uint objectThere, vec3 normalThere) {
  return objectHere == objectThere && dot(normalHere, normalThere) >= leastCosine;
}

// A ray from one of the block's corners, if the surface goes on smoothly to the one opposite.
uint rayFromCorner(ivec2 pixel, int width, uint corner, uint kind) {
  MeshPlace here = placeSeenAt(pixel + (width - 1) * cornerOf(corner));
  MeshPlace there = placeSeenAt(pixel + (width - 1) * cornerOf(3u - corner));
  if (!goesOnSmoothly(here.object, here.normal, there.object, there.normal)) return noRay;
  return rayOfKind(kind, here);
}

// The place of the k-th corner of all. Corners are sorted by the kinds of their rays, so that rays side by
// side are alike and take the same way.
uvec2 placeOfCorner(uint k) {
  const uint even = (widthOfCorners + 1u) / 2u;
  const uint odd = widthOfCorners / 2u;
  if (k < even * even) return 2u * uvec2(k % even, k / even);
  k -= even * even;
  if (k < odd * even) return 2u * uvec2(k % odd, k / odd) + uvec2(1u, 0u);
  k -= odd * even;
  if (k < even * odd) return 2u * uvec2(k % even, k / even) + uvec2(0u, 1u);
  k -= even * odd;
  return 2u * uvec2(k % odd, k / odd) + 1u;
}

uint cornerAt(uvec2 place) {
  return place.y * widthOfCorners + place.x;
}

uint mortonOf(uvec2 place) {
  uint i = 0u;
  for (int bit = 0; bit < 4; ++bit)
    i |= (bitfieldExtract(place.x, bit, 1) | bitfieldExtract(place.y, bit, 1) << 1) << 2 * bit;
  return i;
}

// Whether some surface fills a block around the corner.
bool isWanted(uvec2 place) {
  for (uint i = 0u; i < 4u; ++i) {
    uvec2 block = place - uvec2(cornerOf(i));
    if (all(lessThan(block, uvec2(widthOfCorners - 1u))) && !broken[0][mortonOf(block)]) return true;
  }
  return false;
}

void askCorner(uvec2 place) {
  uint corner = cornerAt(place);
  objectOfCorner[corner] = noObject;
  rayOfCorner[corner] = noRay;
  if (!isWanted(place)) return;
  ivec2 pixel = min(firstPixel() + 4 * ivec2(place), textureSize(seenWords, 0).xy - 1);
  uint word = seenWord(pixel, 0u);
  if (samplesOf(word) != everySample) return;
  MeshPlace here = seenPlace(pixel, word);
  objectOfCorner[corner] = here.object;
  normalOfCorner[corner] = here.normal;
  rayOfCorner[corner] = rayOfKind((place.x & 1u) + 2u * (place.y & 1u), here);
}

// The answers of the rays from a block's corners, a bit for each kind of answer.
uint answerOfCorners(uint block) {
  uvec2 first = placeOfMorton(block);
  uint answer = 0u;
  for (uint i = 0u; i < 4u; ++i) {
    uint here = cornerAt(first + uvec2(cornerOf(i)));
    uint there = cornerAt(first + uvec2(cornerOf(3u - i)));
    bool goesOn = objectOfCorner[here] != noObject &&
                  goesOnSmoothly(objectOfCorner[here], normalOfCorner[here], objectOfCorner[there], normalOfCorner[there]);
    answer |= 1u << (goesOn ? rayOfCorner[here] : noRay);
  }
  return answer;
}

void findBroken() {
  uint i = gl_LocalInvocationIndex;
  for (uint level = 0u; level < levels; ++level)
    for (uint k = i; k < smallest; k += gl_WorkGroupSize.x) broken[level][k] = false;
  barrier();
  for (uint k = i; k < smallest; k += gl_WorkGroupSize.x) {
    shares[k] = unknownShare;
    ivec2 pixel = pixelOfBlock(k);
    spanned[k] = isFilled(pixel) && isFilled(pixel + 1);
    if (spanned[k] && isFilled(pixel + ivec2(1, 0)) && isFilled(pixel + ivec2(0, 1))) continue;
    for (uint level = 0u; level < levels; ++level) broken[level][k >> 2u * (levels - 1u - level)] = true;
  }
}

void putOnList(uint block, uint list) {
  asked[list][atomicAdd(askedCount[list], 1u)] = block;
}

void askQuarters(uint block, uint levelOfQuarters) {
  for (uint quarter = 4u * block; quarter < 4u * block + 4u; ++quarter)
    if (spanned[quarter]) putOnList(quarter, levelOfQuarters);
}

void answerFromCorners(uint count) {
  if (count > 0u)
    for (uint k = gl_LocalInvocationIndex; k < corners; k += gl_WorkGroupSize.x) askCorner(placeOfCorner(k));
  barrier();
  for (uint k = gl_LocalInvocationIndex; k < count; k += gl_WorkGroupSize.x) answers[k] = answerOfCorners(asked[0][k]);
}

void answerFromOpposite(uint level, uint count, uint shift) {
  uint apart = max(count, 1u);
  int width = int(1u << levels - level);
  for (uint k = gl_LocalInvocationIndex; k < count; k += gl_WorkGroupSize.x) answers[k] = 0u;
  barrier();
  for (uint k = gl_LocalInvocationIndex; k < 2u * count; k += gl_WorkGroupSize.x) {
    uint block = asked[level][k % apart];
    uint corner = 3u * (k / apart);
    atomicOr(answers[k % apart], 1u << rayFromCorner(pixelOfBlock(block << shift), width, corner, corner));
  }
  barrier();
  // Wide rays may meet things on both sides of the middle.
  for (uint k = gl_LocalInvocationIndex; k < count; k += gl_WorkGroupSize.x)
    if (answers[k] == 1u << rayMeets)
      answers[k] |= 1u << rayFromCorner(pixelOfBlock(asked[level][k] << shift), width, 0u, inTheMiddle);
}

// Tests the blocks of a level. What is known then is written for the smallest below. The smallest that
// disagree are left to be tested again; of others the quarters are.
void ask(uint level) {
  uint count = askedCount[level];
  uint shift = 2u * (levels - 1u - level);  // from a block's number to that of the first of the smallest in it
  if (level == 0u)
    answerFromCorners(count);
  else
    answerFromOpposite(level, count, shift);
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
    } else if (disagrees && !broken[level][block]) {
      putOnList(block, levels);
    }
  }
  barrier();
}

// Sends rays of the lobe from the smallest blocks that are left, each pixel half of what it would send alone. Blocks
// side by side send different ones.
void askDisagreeing() {
  uint count = askedCount[levels];
  uint apart = max(count, 1u);
  uint rays = 2u * raysOfSample(alpha) * samples;
  for (uint k = gl_LocalInvocationIndex; k < count; k += gl_WorkGroupSize.x) answers[k] = 0u;
  barrier();
  for (uint k = gl_LocalInvocationIndex; k < rays * count; k += gl_WorkGroupSize.x) {
    uint i = k / apart;
    ivec2 pixel = pixelOfBlock(asked[levels][k % apart]);
    MeshPlace place = placeSeenAt(pixel + cornerOf(i % 4u));
    uint ray = reflectedRay(4u * i + (i + cellOf(pixel / 2, 2) & 3u), 4u * rays, place, Mirror(alpha, place.normal));
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
