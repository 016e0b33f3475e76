// Corrects the exitance of vertices, for objects whose light is summed there; that of the backs of sheets follows the
// others.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_CLUSTERS 2
#define BINDING_CLUSTER_NODES 3
#define BINDING_EXITANCES 4
#define BINDING_MEANS 5
#include "lib/carry.glsl"
#include "lib/linear.glsl"
#include "lib/material.glsl"

layout(std430, set = 0, binding = 6) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 7) readonly buffer Normals { vec4 normals[]; };
layout(std430, set = 0, binding = 8) readonly buffer ObjectOf { uint objectOf[]; };
layout(std430, set = 0, binding = 9) readonly buffer Order { uint order[]; };
layout(std430, set = 0, binding = 10) buffer VertexExitances { vec4 vertexExitances[]; };

layout(push_constant) uniform Push {
  uint vertexCount;
  uint sides;  // of bodies with a back
  uint site;
};

void main() {
  uint i = linearIndex();
  bool inside = i < sides * vertexCount;
  bool back = inside && i >= vertexCount;
  uint vertex = inside ? order[back ? i - vertexCount : i] : 0u;
  uint at = back ? vertexCount + vertex : vertex;
  ObjectData body = objects[objectOf[vertex]];
  bool here = inside && body.clusters.z != 0u && !isSummedAtFragments(body, site) && (!back || hasBack(body));
  vec4 known = vertexExitances[at];
  vec3 better = corrected(known.rgb, positions[vertex].xyz, back ? -normals[vertex].xyz : normals[vertex].xyz,
                          insideOf(body), isOpaque(body), false,
                          here ? body.clusters.x : noNode, body.clusters.y);
  if (here) vertexExitances[at] = vec4(better, known.a);
}
