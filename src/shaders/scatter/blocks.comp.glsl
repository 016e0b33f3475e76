// Which blocks of pixels are filled by one smooth surface of a translucent body, and so small that its light changes slowly
// over them: one invocation for each wide block.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_OBJECTS 2
#define BINDING_MEDIA 3
#define MESH_BINDING 5
#define BINDING_SEEN_LIST 9
#include "lib/frame.glsl"
#include "lib/lesser.glsl"
#include "lib/material.glsl"
#include "lib/seen_list.glsl"

layout(std430, set = 0, binding = 4) writeonly buffer Blocks { uint blocks[]; };

layout(push_constant) uniform Push {
  uint firstRow;  // of the band
  uint rows;
  uint site;
};

#include "lib/neighbours.glsl"
#include "lib/blocks.glsl"

// Between knots, in mean free paths of the channel whose light changes fastest.
const float farthestApart = 1.5;

// Of a narrow block's own pixels, and its knots that are the first of other blocks.
const int ownPixels = narrowBlock * narrowBlock;
const ivec2 otherKnots[5] = ivec2[5](ivec2(4, 0), ivec2(4, 2), ivec2(4, 4), ivec2(2, 4), ivec2(0, 4));

ivec2 offsetOf(int i) {
  return i < ownPixels ? ivec2(i % narrowBlock, i / narrowBlock) : otherKnots[i - ownPixels];
}

bool areWhole(ivec2 first) {
  if (any(greaterThanEqual(first + narrowBlock, endOfBand()))) return false;
  for (int i = 0; i < ownPixels + otherKnots.length(); ++i)
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

// Whether knots that far from the middle of a block are near enough to each other.
bool areNear(MeshPlace middle, ivec2 pixel, int away) {
  float reach = farthestApart / largestOf(insideOf(objects[middle.object]).extinction.rgb);
  for (int i = 0; i < 4; ++i) {
    ivec2 knot = pixel + away * ivec2(i % 2 * (i - 2), (i + 1) % 2 * (i - 1));
    if (distance(middle.position, placeAt(knot).position) > reach) return false;
  }
  return true;
}

bool isSummedHere(ObjectData body) {
  // Sums over coarse sources have steps, which the sums over those nearby take away.
  return !isOpaque(body) && isSummedAtFragments(body, site) && body.darkest.w == 0.0;
}

bool isSmooth(ivec2 first) {
  if (!areWhole(first)) return false;
  ivec2 pixel = first + narrowBlock / 2;
  uint triangle = triangleOf(seenWord(pixel, 0u));
  MeshPlace middle = placeAt(pixel);
  if (!isSummedHere(objects[middle.object]) || !areNear(middle, pixel, narrowBlock / 2)) return false;
  for (int i = 0; i < ownPixels + otherKnots.length(); ++i)
    if (!isOneWith(middle, triangle, first + offsetOf(i))) return false;
  return true;
}

// Each quarter goes on where it meets the next, and all of them as the middle does.
bool isSmoothAsAWhole(ivec2 first) {
  ivec2 pixel = first + wideBlock / 2;
  MeshPlace middle = placeAt(pixel);
  for (int i = 0; i < 4; ++i)
    if (!isOneSurface(middle, placeAt(first + narrowBlock / 2 + narrowBlock * ivec2(i & 1, i >> 1)))) return false;
  return areNear(middle, pixel, wideBlock / 2);
}

void main() {
  uint across = (narrowBlocksAcross() + 1u) / 2u;
  uint i = linearIndex();
  ivec2 first = wideBlock * ivec2(i % across, i / across) + ivec2(0, firstRow);
  if (!isInBand(first)) return;
  uint smoothQuarters = 0u;
  for (int quarter = 0; quarter < 4; ++quarter)
    if (isSmooth(first + narrowBlock * ivec2(quarter & 1, quarter >> 1))) smoothQuarters |= 1u << quarter;
  bool wide = smoothQuarters == 0xfu && isSmoothAsAWhole(first);
  for (int quarter = 0; quarter < 4; ++quarter) {
    ivec2 pixel = first + narrowBlock * ivec2(quarter & 1, quarter >> 1);
    if (isInBand(pixel)) blocks[blockOf(pixel)] = wide ? isWide : smoothQuarters >> quarter & isNarrow;
  }
}
