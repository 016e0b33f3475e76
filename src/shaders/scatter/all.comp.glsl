// A range of all surfels, added to the exitance of every surface that pixels see whose object wants it there;
// others keep what their vertices have.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_SOURCES 6
#define MESH_BINDING 7
#define BINDING_SEEN_LIST 11
#define BINDING_MESH_EXITANCES 3
#include "lib/frame.glsl"
#include "lib/seen_list.glsl"
#include "lib/surfel_sum.glsl"

layout(std430, set = 0, binding = 2) buffer Exitances { vec4 exitances[]; };

layout(push_constant) uniform Push {
  uint first;
  uint firstSurfel;
  uint endSurfel;
  uint site;
};

void main() {
  Seen seen = seenOfInvocation(first);
  if (!seen.there) return;
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  ObjectData body = objects[place.object];
  if (isOpaque(body)) return;
  vec4 value = firstSurfel == 0u ? vec4(0.0) : exitances[seen.entry];
  if (isSummedAtFragments(body, site)) {
    value += surfelSumOf(place.position, body, firstSurfel, endSurfel);
  } else if (firstSurfel == 0u) {
    value = meshExitanceAt(place);
  }
  exitances[seen.entry] = value;
}
