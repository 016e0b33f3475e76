// Finds the blocks of pixels that one smooth surface of a translucent body fills, so small that its light changes
// slowly over them. Then lists the surfaces where light is summed first: in blocks the knots, elsewhere all. Surfaces
// of bodies whose light is summed at vertices take it from those.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_SEEN 1
#define BINDING_MESH_EXITANCES 2
#define BINDING_OBJECTS 3
#define BINDING_SURFACES 4
#define MESH_BINDING 9
#define BINDING_MEDIA 13
#define BINDING_MESH_ORIGINS 15
layout(local_size_x = 64) in;
#include "lib/frame.glsl"
#include "lib/lesser.glsl"
#include "lib/material.glsl"
#include "lib/seen.glsl"
#include "lib/listing.glsl"

layout(std430, set = 0, binding = 6) writeonly buffer Blocks { uint blocks[]; };
layout(std430, set = 0, binding = 7) writeonly buffer Exitances { vec4 exitances[]; };
layout(std430, set = 0, binding = 8) writeonly buffer Paint { vec4 paint[]; };
layout(std430, set = 0, binding = 14) readonly buffer Entries { uint entryOfPixel[]; };

layout(std430, set = 0, binding = 16) writeonly buffer Origins { vec4 origins[]; };

layout(constant_id = 0) const uint withPaint = 0u;

layout(push_constant) uniform Push {
  uint firstRow;  // of the band
  uint rows;
  uint site;
  uint interpolates;  // 0: no block is interpolated
  uint samples;       // of a pixel; words of further layers belong to another picture
  uint keepsOrigins;
};

#include "lib/neighbours.glsl"
#include "lib/blocks.glsl"

// Most distance between knots, in mean free paths of the channel whose light changes fastest.
const float farthestApart = 1.5;

// Knots of a narrow block that are the first of other blocks.
const ivec2 otherKnots[5] =
    ivec2[5](ivec2(narrowBlock, 0), ivec2(narrowBlock, narrowBlock / 2), ivec2(narrowBlock),
             ivec2(narrowBlock / 2, narrowBlock), ivec2(0, narrowBlock));

ivec2 offsetOf(int i) {
  return i < pixelsOfBlock ? pixelOfBlock(ivec2(0), i) : otherKnots[i - pixelsOfBlock];
}

bool areWhole(ivec2 first) {
  if (any(greaterThanEqual(first + narrowBlock, endOfBand()))) return false;
  for (int i = 0; i < pixelsOfBlock + otherKnots.length(); ++i)
    if (samplesOf(seenWord(first + offsetOf(i), 0u)) != everySample) return false;
  return true;
}

MeshPlace placeAt(ivec2 pixel) {
  return seenPlace(pixel, seenWord(pixel, 0u));
}

bool isOneWith(MeshPlace middle, uint triangle, ivec2 pixel) {
  uint word = seenWord(pixel, 0u);
  return triangleOf(word) == triangle || isOneSurface(middle, seenPlace(pixel, word));
}

const ivec2 sides[4] = ivec2[4](ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1));

// Whether knots that far from the middle of a block are near enough to each other.
bool areNear(MeshPlace middle, ivec2 pixel, int away) {
  float reach = farthestApart / largestOf(insideOf(objects[middle.object]).extinction.rgb);
  for (int i = 0; i < 4; ++i)
    if (distance(middle.position, placeAt(pixel + away * sides[i]).position) > reach) return false;
  return true;
}

bool isSummedHere(ObjectData body) {
  // Sums over coarse sources have steps, which the sums over nearby ones take away.
  return !isOpaque(body) && isSummedAtFragments(body, site) && body.darkest.w == 0.0;
}

bool isSmooth(ivec2 first) {
  if (!areWhole(first)) return false;
  ivec2 pixel = first + narrowBlock / 2;
  uint triangle = triangleOf(seenWord(pixel, 0u));
  MeshPlace middle = placeAt(pixel);
  if (!isSummedHere(objects[middle.object]) || !areNear(middle, pixel, narrowBlock / 2)) return false;
  for (int i = 0; i < pixelsOfBlock + otherKnots.length(); ++i)
    if (!isOneWith(middle, triangle, first + offsetOf(i))) return false;
  return true;
}

// Quarters join where they meet the next; here all must also agree with the middle.
bool isSmoothAsAWhole(ivec2 first) {
  ivec2 pixel = first + wideBlock / 2;
  MeshPlace middle = placeAt(pixel);
  for (int i = 0; i < 4; ++i)
    if (!isOneSurface(middle, placeAt(first + narrowBlock / 2 + narrowBlock * ivec2(i & 1, i >> 1)))) return false;
  return areNear(middle, pixel, wideBlock / 2);
}

shared bool smoothBlocks[gl_WorkGroupSize.x];
shared bool wideBlocks[gl_WorkGroupSize.x / 4u];

// What is known of the invocation's block.
uint findBlock(ivec2 first) {
  uint i = gl_LocalInvocationIndex;
  smoothBlocks[i] = interpolates != 0u && isInBand(first) && isSmooth(first);
  barrier();
  if (i % 4u == 0u)
    wideBlocks[i / 4u] = smoothBlocks[i] && smoothBlocks[i + 1u] && smoothBlocks[i + 2u] && smoothBlocks[i + 3u] &&
                         isSmoothAsAWhole(first);
  barrier();
  return wideBlocks[i / 4u] ? isWide : smoothBlocks[i] ? isNarrow : 0u;
}

struct SeenHere {
  bool there;
  bool summed;  // at fragments
  uint entry;
  uint word;
};

SeenHere surfaceSeen(ivec2 pixel, uint layer) {
  SeenHere seen = SeenHere(false, false, 0u, 0u);
  if (!isInBand(pixel)) return seen;
  seen.word = seenWord(pixel, layer);
  if (samplesOf(seen.word) == 0u) return seen;
  seen.there = true;
  seen.entry = entryOfPixel[indexOf(pixel)] + layer;
  seen.summed = isSummedAtFragments(objects[objectOfTriangle(triangleOf(seen.word))], site);
  return seen;
}

void giveKnown(ivec2 pixel, SeenHere seen) {
  if (!seen.summed) {
    MeshPlace place = seenPlace(pixel, seen.word);
    exitances[seen.entry] = meshExitanceAt(place);
    if (keepsOrigins != 0u) origins[seen.entry] = meshOriginAt(place);
  }
  if (withPaint != 0u) paint[seen.entry] = vec4(0.0);
}

bool isBetweenKnots(ivec2 pixel, uint block) {
  return block != 0u && !isKnot(pixel, block == isWide ? wideBlock : narrowBlock);
}

// Goes through all of the block's surfaces once and, where they are listed, again. Returns how many are listed.
uint goThrough(ivec2 first, uint block, bool lists, uint start) {
  uint count = 0u;
  for (int i = 0; i < pixelsOfBlock; ++i) {
    ivec2 pixel = pixelOfBlock(first, i);
    for (uint layer = 0u; layer < samples; ++layer) {
      SeenHere seen = surfaceSeen(pixel, layer);
      if (!seen.there) break;
      if (!lists) giveKnown(pixel, seen);
      if (!seen.summed || isBetweenKnots(pixel, block)) continue;
      if (lists) surfaces[start + count] = seen.entry;
      ++count;
    }
  }
  return count;
}

void main() {
  ivec2 first = firstOfInvocation();
  uint block = findBlock(first);
  if (isInBand(first)) blocks[blockOf(first)] = block;
  uint count = goThrough(first, block, false, 0u);
  uint start = placesForSurfaces(count);
  if (count != 0u) goThrough(first, block, true, start);
}
