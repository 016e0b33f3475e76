// Corrects the exitance of surfaces that pixels see.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_SEEN 6
#define BINDING_OBJECTS 7
#define BINDING_MEDIA 1
#define BINDING_CLUSTERS 2
#define BINDING_CLUSTER_NODES 3
#define BINDING_EXITANCES 4
#define BINDING_MEANS 5
#define BINDING_BARE_LIGHTS 16
#define MESH_BINDING 9
#define BINDING_SEEN_LIST 13
#define BINDING_ASKED 18
#define BINDING_NEARBY 21
#include "lib/carry.glsl"
#include "lib/frame.glsl"
#include "lib/material.glsl"
#include "lib/asked_list.glsl"
#include "shared/opaque.h"

layout(std430, set = 0, binding = 8) buffer Found { vec4 found[]; };

layout(std430, set = 0, binding = 15) readonly buffer Materials { SeenMaterial materials[]; };
layout(std430, set = 0, binding = 17) writeonly buffer Paint { vec4 paint[]; };

layout(std430, set = 0, binding = 20) writeonly buffer Origins { vec4 origins[]; };

layout(push_constant) uniform Push {
  uint first;
  uint keepsOrigins;
};

void main() {
  Seen seen = askedOfInvocation(first);
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  ObjectData body = objects[place.object];
  bool here = seen.there && body.clusters.z != 0u;
  vec4 known = found[seen.entry];
  bool opaque = isOpaque(body);
  bool painted = withPaint != 0u && mediumAt(body, place.position).tables.z != 0u;
  vec3 normal = hasBack(body) ? place.normal : place.side * place.normal;
  Carried carried = corrected(known.rgb, place.position, normal, insideOf(body),
                              opaque, painted, here ? body.clusters.x : noNode, body.clusters.y);
  vec3 better = carried.exitance;
  if (keepsOrigins != 0u && seen.there) origins[seen.entry] = here ? carried.origin : unknownOrigin;
  if (here && opaque) better = mix(known.rgb, better, materials[seen.entry].normal.w);
  if (here) found[seen.entry] = vec4(better, known.a);
  if (withPaint != 0u && seen.there) paint[seen.entry] = vec4(enteredAround, 0.0);
}
