// How much of what translucent surfaces on a list mirror towards the camera is sky: rays of the GGX lobe that
// meet nothing. Each of a pixel's samples that see a surface has some of the lobe's rays.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_SEEN_LIST 2
#define MESH_BINDING 9
#define BINDING_OBJECTS 4
#define BINDING_PIECE_CORNERS 5
#define BINDING_RAYS 6
#define BINDING_ASKED 13
#include "lib/bodies.glsl"
#include "lib/frame.glsl"
#include "lib/asked_list.glsl"
#include "lib/sky_rays.glsl"
#include "shared/opaque.h"

layout(std430, set = 0, binding = 7) writeonly buffer SkyShares { float skyShares[]; };

// Some translucent surfaces have a roughness or normals of their own.
layout(constant_id = 0) const uint withOwnSurfaces = 0u;
layout(std430, set = 0, binding = 8) readonly buffer Materials { SeenMaterial materials[]; };

// The widest rays go first, then, unless the lobe is narrow, one from its middle: where these agree, so do the others.
float shareOfSky(MeshPlace place, Mirror mirror, uint seeing) {
  uint sent = 0u;
  uint free = 0u;
  uint rays = raysOfSample(mirror.alpha);
  uint raysInAll = rays * samples;
  uint widest = max(raysInAll / 4u, 2u);
  uint enough = rays == 1u ? widest : widest + 1u;
  for (uint k = 0u; k < raysInAll; ++k) {
    bool agreed = free == 0u || free == sent;
    if (seeing == everySample && k == enough && agreed) break;
    uint i = k < widest ? raysInAll - 1u - k : k - widest;
    if ((seeing >> i / rays & 1u) == 0u) continue;
    uint ray = reflectedRay(i, raysInAll, place, mirror);
    if (ray == noRay) continue;
    ++sent;
    free += ray;
  }
  return sent > 0u ? float(free) / float(sent) : 1.0;
}

void main() {
  Seen seen = askedOfInvocation(first);
  if (!seen.there) return;
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  Mirror mirror = Mirror(alpha, place.normal);
  if (withOwnSurfaces != 0u) mirror = Mirror(materials[seen.entry].diffuse.w, materials[seen.entry].normal.xyz);
  skyShares[seen.entry] = shareOfSky(place, mirror, samplesOf(seen.word));
}
