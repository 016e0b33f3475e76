// Corrects the exitance of vertices, for objects whose light is summed there.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_CLUSTERS 2
#define BINDING_CLUSTER_NODES 3
#define BINDING_EXITANCES 4
#define BINDING_MEANS 5
#define BINDING_NEARBY 12
#include "lib/carry.glsl"
#include "lib/linear.glsl"
#include "lib/material.glsl"
#include "lib/vertex_side.glsl"

layout(std430, set = 0, binding = 6) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 7) readonly buffer Normals { vec4 normals[]; };
layout(std430, set = 0, binding = 8) readonly buffer ObjectOf { uint objectOf[]; };
layout(std430, set = 0, binding = 9) readonly buffer Order { uint order[]; };
layout(std430, set = 0, binding = 10) buffer VertexExitances { vec4 vertexExitances[]; };

layout(std430, set = 0, binding = 11) writeonly buffer Origins { vec4 origins[]; };

layout(push_constant) uniform Push {
  uint vertexCount;
  uint sides;  // of bodies with a back
  uint site;
};

void main() {
  uint i = linearIndex();
  bool inside = i < sides * vertexCount;
  VertexSide side = vertexSideOf(inside ? i : 0u, vertexCount);
  uint vertex = order[side.vertex];
  uint at = side.back ? vertexCount + vertex : vertex;
  ObjectData body = objects[objectOf[vertex]];
  bool here = inside && body.clusters.z != 0u && !isSummedAtFragments(body, site) && hasSide(body, side);
  vec4 known = vertexExitances[at];
  Carried carried = corrected(known.rgb, positions[vertex].xyz, outwardsOf(side, normals[vertex].xyz),
                              insideOf(body), isOpaque(body), false,
                              here ? body.clusters.x : noNode, body.clusters.y);
  if (here) vertexExitances[at] = vec4(carried.exitance, known.a);
  if (inside && !side.back) origins[vertex] = here ? carried.origin : unknownOrigin;
}
