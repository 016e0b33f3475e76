// Adds what sums over coarse sources leave out nearby to the exitance of vertices.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define SHADOW_BINDING 6
#define BINDING_SKY_IRRADIANCE 7
#define BINDING_NODES 8
#define BINDING_SOURCES 9
#define BINDING_SURFEL_NORMALS 10
#define BINDING_SKY_SHARES 13
#define BINDING_THROUGH_PAINT 14
#include "lib/irradiance.glsl"
#include "lib/nearby.glsl"
#include "lib/linear.glsl"
#include "lib/unit.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 2) readonly buffer ObjectOf { uint objectOf[]; };
layout(std430, set = 0, binding = 3) buffer Exitance { vec4 exitances[]; };
layout(std430, set = 0, binding = 11) readonly buffer Normals { vec4 normals[]; };
layout(std430, set = 0, binding = 12) readonly buffer Order { uint order[]; };

layout(push_constant) uniform Push {
  uint vertexCount;
  uint site;
};

void main() {
  uint i = linearIndex();
  if (i >= vertexCount) return;
  uint vertex = order[i];
  ObjectData body = objects[objectOf[vertex]];
  if (body.darkest.w == 0.0 || isSummedAtFragments(body, site)) return;
  vec3 normal = unitOr(normals[vertex].xyz, vec3(0.0, 1.0, 0.0));
  exitances[vertex] += nearbyExitance(positions[vertex].xyz, normal, LitNormals(normal, normal, normal), body);
}
