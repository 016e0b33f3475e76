// How much of what a translucent surface mirrors towards the camera is sky, of all that pixels see: rays of the
// GGX lobe that meet nothing. Each of a pixel's samples that see it has some of the lobe's rays.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_SEEN_LIST 2
#define MESH_BINDING 9
#define BINDING_OBJECTS 4
#define BINDING_PIECE_CORNERS 5
#define BINDING_RAYS 6
#include "lib/bodies.glsl"
#include "lib/frame.glsl"
#include "lib/seen_list.glsl"
#include "lib/sky_rays.glsl"
#include "shared/opaque.h"

layout(std430, set = 0, binding = 7) buffer Light { vec4 light[]; };  // the share in w
layout(set = 0, binding = 8) uniform usampler2D skyBlocks;  // of 2×2 pixels

// Some translucent surfaces have a roughness or normals of their own.
layout(constant_id = 0) const uint withOwnSurfaces = 0u;
layout(std430, set = 0, binding = 13) readonly buffer Materials { SeenMaterial materials[]; };

// The widest go first: where those agree, so do the others within the lobe.
float shareOfSky(MeshPlace place, Mirror mirror, uint seeing) {
  uint sent = 0u;
  uint free = 0u;
  uint rays = raysOfSample(mirror);
  uint raysInAll = rays * samples;
  uint enough = max(raysInAll / 4u, 2u);
  for (uint left = raysInAll; left > 0u; --left) {
    bool agreed = free == 0u || free == sent;
    if (seeing == everySample && raysInAll - left == enough && agreed) break;
    uint i = left - 1u;
    if ((seeing >> i / rays & 1u) == 0u) continue;
    uint ray = reflectedRay(i, place, mirror);
    if (ray == noRay) continue;
    ++sent;
    free += ray;
  }
  return sent > 0u ? float(free) / float(sent) : 1.0;
}

// Surfaces in blocks that tell nothing: few of a group's, and traced side by side.
shared uint waitingCount;
shared uint waiting[64];

void main() {
  uint i = gl_LocalInvocationIndex;
  if (i == 0u) waitingCount = 0u;
  barrier();
  Seen seen = seenOfInvocation(first);
  uint block = texelFetch(skyBlocks, seen.pixel / 2, 0).r;
  seen.there = seen.there && !isOpaque(objects[objectOfTriangle(triangleOf(seen.word))]);
  if (seen.there && block == noRay) waiting[atomicAdd(waitingCount, 1u)] = seen.entry;
  if (seen.there && block != noRay) light[seen.entry].w = float(block);
  barrier();
  if (i >= waitingCount) return;
  seen = seenOfEntry(waiting[i]);
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  Mirror mirror = Mirror(alpha, place.normal);
  if (withOwnSurfaces != 0u) mirror = Mirror(materials[seen.entry].diffuse.w, materials[seen.entry].normal.xyz);
  light[seen.entry].w = shareOfSky(place, mirror, samplesOf(seen.word));
}
