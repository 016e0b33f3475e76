// The sum over the tree at every vertex, neighbours in space side by side. A rough sum first tells how
// bright each is; then, where the site is the vertices, the sum is taken to the tolerance of that.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_NODES 6
#define BINDING_SOURCES 7
#include "lib/tree_sum.glsl"
#include "lib/tolerance.glsl"
#include "lib/linear.glsl"

layout(constant_id = 3) const uint rough = 0u;

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 2) readonly buffer ObjectOf { uint objectOf[]; };
layout(std430, set = 0, binding = 3) buffer Exitance { vec4 exitances[]; };
layout(std430, set = 0, binding = 8) readonly buffer Order { uint order[]; };

layout(push_constant) uniform Push {
  uint vertexCount;
  float tolerance;
  uint site;
};

void main() {
  uint i = linearIndex();
  bool inside = i < vertexCount;
  uint vertex = inside ? order[i] : 0u;
  ObjectData body = objects[objectOf[vertex]];
  bool here = inside && (rough != 0u || !isSummedAtFragments(body, site)) && !isOpaque(body);
  uint root = here && body.tree.x < body.tree.y ? body.tree.x : noNode;
  vec3 position = positions[vertex].xyz;
  Profile profile = mediumAt(body, position).profile;
  vec4 sum = rough != 0u
                 ? vec4(max(roughSum(position, body, root, profile), darkestOf(body, root)), 0.0)
                 : treeSum(position, root, body.tree.y, profile, body.darkest.w,
                           toleratedAt(exitances[vertex].rgb, tolerance));
  if (here) exitances[vertex] = sum;
}
