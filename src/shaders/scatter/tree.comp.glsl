// The sum over the tree at every visible pixel whose object wants it there; others keep what their
// vertices have. How bright a place is, roughly, comes interpolated from the vertices.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_NODES 6
#define BINDING_SOURCES 7
#include "lib/tree_sum.glsl"
#include "lib/tile.glsl"
#include "lib/tolerance.glsl"

layout(set = 0, binding = 1) uniform sampler2D surfacePosition;
layout(set = 0, binding = 2, rgba32f) uniform writeonly image2D exitance;
layout(set = 0, binding = 3) uniform sampler2D vertexExitance;

layout(push_constant) uniform Push {
  float tolerance;
  uint site;
};

void main() {
  ivec2 pixel = pixelOfInvocation();
  bool inside = all(lessThan(pixel, imageSize(exitance)));
  vec4 surface = inside ? texelFetch(surfacePosition, pixel, 0) : vec4(0.0);
  bool covered = surface.w > 0.0;
  vec4 known = inside ? texelFetch(vertexExitance, pixel, 0) : vec4(0.0);
  ObjectData body = objects[covered ? uint(surface.w) - 1u : 0u];
  bool here = covered && isSummedAtFragments(body, site);
  uint root = here && body.tree.x < body.tree.y ? body.tree.x : noNode;
  Profile profile = mediumAt(body, surface.xyz).profile;
  // Vertices far apart know nothing of what lies between them.
  bool coarse = here && body.table.w != 0u;
  vec3 there = roughSum(surface.xyz, body, coarse ? root : noNode, profile);
  vec3 about = max(coarse ? there : known.rgb, darkestOf(body, root));
  vec4 sum = treeSum(surface.xyz, root, body.tree.y, profile, body.darkest.w,
                     toleratedAt(about, tolerance));
  if (inside)
    imageStore(exitance, pixel, covered ? here ? sum : known : vec4(0.0));
}
