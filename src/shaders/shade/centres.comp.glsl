// What the pixels' centres see, for callers that ask.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_SEEN_LIST 10
#define BINDING_MESH_EXITANCES 2
#define MESH_BINDING 6
#define BINDING_OBJECTS 13
#include "lib/bodies.glsl"
#include "lib/frame.glsl"
#include "lib/seen_list.glsl"
#include "shared/opaque.h"
#include "lib/diffuse_exitance.glsl"

layout(std430, set = 0, binding = 12) readonly buffer Light { vec4 light[]; };  // exitance, or irradiance of opaque
                                                                                // surfaces
layout(set = 0, binding = 3, rgba32f) uniform writeonly image2D positionObject;  // mm; object + 1
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D unitNormal;  // towards the camera
layout(set = 0, binding = 5, rgba32f) uniform writeonly image2D exitance;

layout(std430, set = 0, binding = 14) readonly buffer Materials { SeenMaterial materials[]; };

layout(push_constant) uniform Push {
  uint atFragments;  // 1: it stands in `light`; 0: at the vertices
  uint vertexCount;
};

void main() {
  Seen seen = seenOfInvocation(0u);
  if (!seen.there) return;
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  imageStore(positionObject, seen.pixel, vec4(place.position, float(place.object + 1u)));
  imageStore(unitNormal, seen.pixel, vec4(place.normal, place.side));
  vec4 found = atFragments != 0u ? light[seen.entry] : meshExitanceAt(place);
  if (isOpaque(objects[place.object])) {
    SeenMaterial material = materials[seen.entry];
    found.rgb = atFragments != 0u ? ofBothSides(material, found.rgb, material.behind.rgb)
                                  : diffuseExitanceOfVertices(place, material, vertexCount);
  }
  imageStore(exitance, seen.pixel, found);
}
