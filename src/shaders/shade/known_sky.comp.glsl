// How much of what surfaces mirror is sky, where blocks tell it, and a list of the other surfaces. Where blocks side
// by side differ and the lobe is wide, it is interpolated between them.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_SEEN 1
#define BINDING_SEEN_LIST 2
#define MESH_BINDING 9
#define BINDING_OBJECTS 4
#define BINDING_SURFACES 7
#include "lib/bodies.glsl"
#include "lib/frame.glsl"
#include "lib/seen_entry.glsl"
#include "lib/work_group.glsl"
#include "lib/listing.glsl"
#include "lib/reflected_rays.glsl"
#include "lib/sky_block.glsl"

layout(std430, set = 0, binding = 5) writeonly buffer SkyShares { float skyShares[]; };
layout(set = 0, binding = 6) uniform sampler2D skyBlocks;

layout(push_constant) uniform Push {
  uint firstRow;  // of the band
  uint rows;
  float alpha;  // roughness²
};

int endOfBand() {
  return int(firstRow + rows);
}

// Between the four blocks around the corner of its own that is nearest to a pixel, as far as they are known. Where
// one surface fills each, it fills all but in rare cases.
float shareBetweenBlocks(ivec2 pixel) {
  ivec2 corner = (pixel + 1) / 2;
  vec4 shares = textureGather(skyBlocks, vec2(corner) / vec2(textureSize(skyBlocks, 0)));
  vec2 last = mix(vec2(0.25), vec2(0.75), equal(corner, pixel / 2));
  vec2 before = 1.0 - last;
  if (2 * corner.y >= endOfBand()) last.y = 0.0;
  if (2 * corner.y <= int(firstRow)) before.y = 0.0;
  vec4 weights = vec4(before.x * last.y, last.x * last.y, last.x * before.y, before.x * before.y);
  weights = mix(weights, vec4(0.0), equal(shares, vec4(unknownShare)));
  return dot(weights, shares) / dot(weights, vec4(1.0));
}

// The entry if it has to be asked, else noSurface.
uint askedOf(Seen seen) {
  float share = texelFetch(skyBlocks, seen.pixel / 2, 0).r;
  if (!seen.there || isOpaque(objects[objectOfTriangle(triangleOf(seen.word))])) return noSurface;
  if (share == unknownShare) return seen.entry;
  skyShares[seen.entry] = alpha >= leastAlphaShared ? shareBetweenBlocks(seen.pixel) : share;
  return noSurface;
}

void main() {
  uint asked[mostRounds];
  uint places[mostRounds];
  for (uint round = 0u; round < roundsOfListing(); ++round) {
    asked[round] = askedOf(seenAt(groupIndex() * groupSize + placeInRounds(round)));
    places[round] = asked[round] != noSurface ? 1u : 0u;
  }
  placesForSurfaces(places);
  for (uint round = 0u; round < roundsOfListing(); ++round)
    if (asked[round] != noSurface) surfaces[places[round]] = asked[round];
}
