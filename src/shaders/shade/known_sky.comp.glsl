// How much of what surfaces mirror is sky, where blocks tell it, and a list of the other surfaces.
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
#include "lib/sky_block.glsl"

layout(std430, set = 0, binding = 5) writeonly buffer SkyShares { float skyShares[]; };
layout(set = 0, binding = 6) uniform sampler2D skyBlocks;

// The entry if it has to be asked, else noSurface.
uint askedOf(Seen seen) {
  float share = texelFetch(skyBlocks, seen.pixel / 2, 0).r;
  if (!seen.there || isOpaque(objects[objectOfTriangle(triangleOf(seen.word))])) return noSurface;
  if (share == unknownShare) return seen.entry;
  skyShares[seen.entry] = share;
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
