// Lists the surfaces that the pixels of a band see, those of one pixel together.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_SURFACES 1
#include "lib/morton.glsl"
#include "lib/work_group.glsl"
#include "lib/listing.glsl"

layout(set = 0, binding = 0) uniform usampler2DArray words;
layout(std430, set = 0, binding = 3) writeonly buffer Entries { uint entryOfPixel[]; };  // of its first surface

layout(push_constant) uniform Push {
  uint samples;
  uint firstRow;
};

uint surfacesOf(ivec2 pixel) {
  if (any(greaterThanEqual(pixel, textureSize(words, 0).xy))) return 0u;
  uint count = 0u;
  // Words of further layers hold triangles, with no sample.
  while (count < samples && texelFetch(words, ivec3(pixel, count), 0).r >> seenSamplesShift != 0u) ++count;
  return count;
}

// A work group has a tile of 8×8 pixels.
ivec2 pixelOfRound(uint round) {
  return ivec2(gl_WorkGroupID.xy * 8u + placeOfMorton(placeInRounds(round))) + ivec2(0, firstRow);
}

void main() {
  uint counts[mostRounds];
  for (uint round = 0u; round < roundsOfListing(); ++round) counts[round] = surfacesOf(pixelOfRound(round));
  uint places[mostRounds] = counts;
  placesForSurfaces(places);
  for (uint round = 0u; round < roundsOfListing(); ++round) {
    ivec2 pixel = pixelOfRound(round);
    uint index = uint(pixel.y * textureSize(words, 0).x + pixel.x);
    for (uint layer = 0u; layer < counts[round]; ++layer)
      surfaces[places[round] + layer] = index | layer << seenLayerShift;
    if (counts[round] != 0u) entryOfPixel[index - firstRow * uint(textureSize(words, 0).x)] = places[round];
  }
}
