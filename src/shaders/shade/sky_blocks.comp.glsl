// Whether all of 2×2 pixels mirror the sky, or none of it, where one smooth surface fills them: by the
// widest two rays of the lobe, from opposite corners.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define MESH_BINDING 6
#define BINDING_OBJECTS 2
#define BINDING_PIECE_CORNERS 3
#define BINDING_RAYS 4
#include "lib/bodies.glsl"
#include "lib/frame.glsl"
#include "lib/seen.glsl"
#include "lib/sky_rays.glsl"
#include "lib/tile.glsl"

layout(set = 0, binding = 5, r32ui) writeonly uniform uimage2D skyBlocks;

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
  uint widest = raysInAll - 1u;
  uint ray = reflectedRay(widest, first);
  return ray == reflectedRay(max(widest, 1u) - 1u, last) ? ray : noRay;
}

void main() {
  ivec2 block = pixelOfInvocation() + ivec2(0, first / 2u);
  if (all(lessThan(block, imageSize(skyBlocks)))) imageStore(skyBlocks, block, uvec4(rayOfBlock(2 * block)));
}
