// Irradiance on the other side of opaque surfaces that pixels see, where some of it gets through: from lights with
// shadow maps, and what clusters know. opaque_area_lights.comp adds that of area lights.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_SEEN 1
#define BINDING_OBJECTS 2
#define BINDING_MEDIA 3
#define SHADOW_BINDING 4
#define BINDING_SEEN_LIST 5
#define MESH_BINDING 7
#define BINDING_CLUSTERS 11
#define BINDING_CLUSTER_NODES 12
#define BINDING_EXITANCES 13
#define BINDING_MEANS 14
#define BINDING_PIECE_CORNERS 16
#define BINDING_RAYS 17
#define BINDING_CLUSTER_PAINTS 18
#define THROUGH_BINDING 19
#include "lib/carry.glsl"
#include "lib/frame.glsl"
#include "lib/material.glsl"
#include "lib/seen_list.glsl"
#include "lib/footprint.glsl"
#include "shared/opaque.h"

layout(std430, set = 0, binding = 15) buffer Materials { SeenMaterial materials[]; };

layout(push_constant) uniform Push {
  uint first;
  uint nodeCount;  // of all surfels' trees
  uint piecesPerSurfel;
};

#include "lib/irradiance.glsl"

void main() {
  Seen seen = seenOfInvocation(first);
  MeshPlace place = otherSideOf(seenPlace(seen.pixel, seen.word));
  ObjectData body = objects[place.object];
  bool here = seen.there && letsThrough(body);
  vec3 known = vec3(0.0);
  if (here) {
    if (withThinParts != 0u) extent = lengthsOver(seen, place);
    known = lightsIrradiance(liftedPlace(place), -materials[seen.entry].normal.xyz, place.normal,
                             mediumAt(body, place.position));
  }
  vec3 found = corrected(known, place.position, place.normal, insideOf(body), true, false,
                         here ? body.clusters.x : noNode, body.clusters.y).exitance;
  if (here) materials[seen.entry].behind = vec4(mix(known, found, materials[seen.entry].normal.w), 0.0);
}
