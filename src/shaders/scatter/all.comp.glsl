// Adds a range of all surfels to the exitance of surfaces that pixels see.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_SOURCES 6
#define MESH_BINDING 7
#define BINDING_SEEN_LIST 11
#define BINDING_ASKED 13
#include "lib/frame.glsl"
#include "lib/asked_list.glsl"
#include "lib/surfel_sum.glsl"

layout(std430, set = 0, binding = 2) buffer Exitances { vec4 exitances[]; };

layout(push_constant) uniform Push {
  uint first;
  uint firstSurfel;
  uint endSurfel;
};

void main() {
  Seen seen = askedOfInvocation(first);
  if (!seen.there) return;
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  ObjectData body = objects[place.object];
  if (isOpaque(body)) return;
  vec4 before = firstSurfel == 0u ? vec4(0.0) : exitances[seen.entry];
  exitances[seen.entry] = before + surfelSumOf(place.position, body, firstSurfel, endSurfel);
}
