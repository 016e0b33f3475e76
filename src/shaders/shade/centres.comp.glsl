// What the pixels' centres see, for whoever wants to know.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_SEEN_LIST 10
#define BINDING_MESH_EXITANCES 2
#define MESH_BINDING 6
#include "lib/frame.glsl"
#include "lib/seen_list.glsl"

layout(std430, set = 0, binding = 12) readonly buffer Light { vec4 light[]; };  // exitance
layout(set = 0, binding = 3, rgba32f) uniform writeonly image2D positionObject;  // mm; object + 1
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D unitNormal;  // towards the camera
layout(set = 0, binding = 5, rgba32f) uniform writeonly image2D exitance;

layout(push_constant) uniform Push {
  uint atFragments;  // it stands in `light`, else at the vertices
};

void main() {
  Seen seen = seenOfInvocation(0u);
  if (!seen.there) return;
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  imageStore(positionObject, seen.pixel, vec4(place.position, float(place.object + 1u)));
  imageStore(unitNormal, seen.pixel, vec4(place.normal, place.side));
  imageStore(exitance, seen.pixel, atFragments != 0u ? light[seen.entry] : meshExitanceAt(place));
}
