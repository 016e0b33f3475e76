// Whether all of 2×2 pixels mirror the sky, or none of it, where one smooth surface fills them: by the
// widest two rays of the lobe, from opposite corners.
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
#include "lib/sky_rays.glsl"
#include "lib/tile.glsl"

layout(set = 0, binding = 5, r32ui) writeonly uniform uimage2D skyBlocks;

// Some translucent surfaces have a roughness or normals of their own, and are not smooth.
layout(constant_id = 0) const uint withOwnSurfaces = 0u;

// Between two corners' normals: what turns further may mirror other things between them.
const float leastCosine = 0.97;

bool isFilled(ivec2 corner) {
  if (any(greaterThanEqual(corner + 1, textureSize(seenWords, 0).xy))) return false;
  for (int i = 0; i < 4; ++i)
    if (samplesOf(seenWord(corner + ivec2(i & 1, i >> 1), 0u)) != everySample) return false;
  return true;
}

uint rayOfBlock(ivec2 corner) {
  if (!isFilled(corner)) return noRay;
  MeshPlace first = seenPlace(corner, seenWord(corner, 0u));
  MeshPlace last = seenPlace(corner + 1, seenWord(corner + 1, 0u));
  if (first.object != last.object || dot(first.normal, last.normal) < leastCosine) return noRay;
  if (withOwnSurfaces != 0u && hasOwnSurface(mediumAt(objects[first.object], first.position))) return noRay;
  uint widest = raysOfSample(Mirror(alpha, first.normal)) * samples - 1u;
  uint ray = reflectedRay(widest, first, Mirror(alpha, first.normal));
  return ray == reflectedRay(max(widest, 1u) - 1u, last, Mirror(alpha, last.normal)) ? ray : noRay;
}

void main() {
  ivec2 block = pixelOfInvocation() + ivec2(0, first / 2u);
  if (all(lessThan(block, imageSize(skyBlocks)))) imageStore(skyBlocks, block, uvec4(rayOfBlock(2 * block)));
}
