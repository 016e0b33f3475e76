// Adds what sums over coarse sources leave out nearby to the exitance of surfaces that pixels see.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define SHADOW_BINDING 6
#define BINDING_SKY_IRRADIANCE 7
#define BINDING_NODES 8
#define BINDING_SOURCES 9
#define BINDING_SURFEL_NORMALS 10
#define BINDING_SKY_SHARES 17
#define BINDING_THROUGH_PAINT 18
#define MESH_BINDING 11
#define BINDING_SEEN_LIST 15
#include "lib/irradiance.glsl"
#define BINDING_OPAQUES 19
#define BINDING_TEXELS 22
#include "lib/nearby_normals.glsl"
#include "lib/seen_list.glsl"

// Some bodies have normal textures.
layout(constant_id = 2) const uint withNormals = 0u;

layout(std430, set = 0, binding = 2) buffer Exitances { vec4 exitances[]; };

layout(push_constant) uniform Push {
  uint first;
  uint site;
};

void main() {
  Seen seen = seenOfInvocation(first);
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  ObjectData body = objects[place.object];
  if (seen.there && body.darkest.w != 0.0 && isSummedAtFragments(body, site)) {
    vec3 outwards = place.side * place.normal;
    LitNormals lit = LitNormals(outwards, outwards, outwards);
    if (withNormals != 0u) lit = litNormalsAt(seen, place, body);
    exitances[seen.entry] += nearbyExitance(place.position, outwards, lit, body);
  }
}
