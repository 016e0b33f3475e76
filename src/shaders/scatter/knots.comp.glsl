// Lists the surfaces that pixels see where light is summed at first: of those in blocks the knots, and all others. Surfaces
// of bodies whose light is summed at vertices have what these have.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_SEEN 1
#define BINDING_MESH_EXITANCES 2
#define BINDING_OBJECTS 3
#define BINDING_SURFACES 4
#define MESH_BINDING 9
#define BINDING_SEEN_LIST 13
#include "lib/frame.glsl"
#include "lib/bodies.glsl"
#include "lib/listing.glsl"
#include "lib/seen_list.glsl"

layout(std430, set = 0, binding = 6) readonly buffer Blocks { uint blocks[]; };
layout(std430, set = 0, binding = 7) writeonly buffer Exitances { vec4 exitances[]; };
layout(std430, set = 0, binding = 8) writeonly buffer Paint { vec4 paint[]; };

layout(constant_id = 0) const uint withPaint = 0u;

layout(push_constant) uniform Push {
  uint firstRow;  // of the band
  uint rows;
  uint site;
  uint interpolates;  // 0: no block does
};

#include "lib/neighbours.glsl"
#include "lib/blocks.glsl"

bool isBetweenKnots(Seen seen) {
  if (interpolates == 0u) return false;
  uint block = blocks[blockOf(seen.pixel)];
  return block != 0u && !isKnot(seen.pixel, block == isWide ? wideBlock : narrowBlock);
}

void main() {
  Seen seen = seenOfInvocation(0u);
  bool here = seen.there && isSummedAtFragments(objects[objectOfTriangle(triangleOf(seen.word))], site);
  if (seen.there && !here) exitances[seen.entry] = meshExitanceAt(seenPlace(seen.pixel, seen.word));
  if (withPaint != 0u && seen.there) paint[seen.entry] = vec4(0.0);
  bool asks = here && !isBetweenKnots(seen);
  uint place = placesForSurfaces(asks ? 1u : 0u);
  if (asks) surfaces[place] = seen.entry;
}
