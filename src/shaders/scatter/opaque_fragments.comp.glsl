// What opaque bodies give back, of surfaces that pixels see, of the light of lights with shadow maps.
// Clusters have the rest.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_OBJECTS 3
#define BINDING_MEDIA 4
#define SHADOW_BINDING 5
#define MESH_BINDING 6
#define BINDING_SEEN_LIST 10
#include "lib/frame.glsl"
#include "lib/opaque.glsl"
#include "lib/seen_list.glsl"

layout(std430, set = 0, binding = 2) buffer Exitances { vec4 exitances[]; };

layout(push_constant) uniform Push {
  uint first;
  uint site;
};

void main() {
  Seen seen = seenOfInvocation(first);
  if (!seen.there) return;
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  ObjectData body = objects[place.object];
  if (!isOpaque(body) || !isSummedAtFragments(body, site)) return;
  vec3 found = givenBack(place.position, place.side * place.normal, place.side * place.facet, body);
  exitances[seen.entry] = vec4(found, 0.0);
}
