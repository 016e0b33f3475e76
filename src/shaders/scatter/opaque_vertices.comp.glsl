// Irradiance from lights with shadow maps at the vertices of opaque bodies. opaque_area_vertices.comp adds
// that of area lights; clusters have the rest.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 3
#define BINDING_MEDIA 4
#define SHADOW_BINDING 5
#define BINDING_PIECE_CORNERS 8
#define BINDING_RAYS 9
#define BINDING_CLUSTER_PAINTS 10
#define THROUGH_BINDING 11
#include "lib/linear.glsl"
#include "lib/material.glsl"
#include "lib/vertex_side.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 2) readonly buffer Normals { vec4 normals[]; };
layout(std430, set = 0, binding = 6) readonly buffer ObjectOf { uint objectOf[]; };
layout(std430, set = 0, binding = 7) buffer Irradiances { vec4 irradiances[]; };

layout(push_constant) uniform Push {
  uint vertexCount;
  uint sides;  // of bodies with a back
  uint site;
  uint nodeCount;  // of all surfels' trees
  uint piecesPerSurfel;
};

#include "lib/irradiance.glsl"

void main() {
  uint i = linearIndex();
  if (i >= sides * vertexCount) return;
  VertexSide side = vertexSideOf(i, vertexCount);
  ObjectData body = objects[objectOf[side.vertex]];
  if (!isOpaque(body) || !hasSide(body, side)) return;
  vec3 place = positions[side.vertex].xyz;
  vec3 normal = outwardsOf(side, normals[side.vertex].xyz);
  irradiances[i] = isSummedAtFragments(body, site)
                       ? vec4(0.0)
                       : vec4(lightsIrradiance(place, normal, normal, mediumAt(body, place)), 0.0);
}
