// What opaque bodies give back at their vertices of the light of lights with shadow maps. Clusters have
// the rest.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 3
#define BINDING_MEDIA 4
#define SHADOW_BINDING 5
#include "lib/linear.glsl"
#include "lib/opaque.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 2) readonly buffer Normals { vec4 normals[]; };
layout(std430, set = 0, binding = 6) readonly buffer ObjectOf { uint objectOf[]; };
layout(std430, set = 0, binding = 7) buffer Exitances { vec4 exitances[]; };

layout(push_constant) uniform Push {
  uint vertexCount;
  uint site;
};

void main() {
  uint i = linearIndex();
  if (i >= vertexCount) return;
  ObjectData body = objects[objectOf[i]];
  if (!isOpaque(body)) return;
  vec3 normal = normals[i].xyz;
  exitances[i] = isSummedAtFragments(body, site)
                     ? vec4(0.0)
                     : vec4(givenBack(positions[i].xyz, normal, normal, body), 0.0);
}
