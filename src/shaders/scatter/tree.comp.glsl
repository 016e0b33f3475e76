// The sum over the tree at surfaces that pixels see.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_SEEN 1
#define BINDING_MESH_EXITANCES 3
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_NODES 6
#define BINDING_SOURCES 7
#define MESH_BINDING 8
#define BINDING_SEEN_LIST 12
#define BINDING_ASKED 14
#include "lib/frame.glsl"
#include "lib/asked_list.glsl"
#include "lib/tree_sum.glsl"
#include "lib/tolerance.glsl"

layout(std430, set = 0, binding = 2) writeonly buffer Exitances { vec4 exitances[]; };

layout(push_constant) uniform Push {
  uint first;
  float tolerance;
};

// About how bright the place is. Vertices that are far apart know nothing of what lies between them.
vec3 estimateAt(MeshPlace place, ObjectData body, uint root, Profile profile) {
  if (estimated == 0u) return vec3(0.0);
  bool coarse = body.table.w != 0u;
  vec3 there = roughSum(place.position, body, coarse ? root : noNode, profile);
  return max(coarse ? there : meshExitanceAt(place).rgb, darkestOf(body, root));
}

void main() {
  Seen seen = askedOfInvocation(first);
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  ObjectData body = objects[place.object];
  bool here = seen.there && !isOpaque(body);
  uint root = here && body.tree.x < body.tree.y ? body.tree.x : noNode;
  Profile profile = mediumAt(body, place.position).profile;
  vec3 about = estimateAt(place, body, root, profile);
  vec4 sum = treeSum(place.position, root, body.tree.y, profile, body.darkest.w,
                     toleratedAt(about, tolerance));
  if (here) exitances[seen.entry] = sum;
}
