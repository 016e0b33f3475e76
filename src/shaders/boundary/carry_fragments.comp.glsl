// Corrects the exitance of visible pixels, for objects whose light is summed there.
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
#include "lib/material.glsl"
#include "lib/tile.glsl"

layout(set = 0, binding = 6) uniform sampler2D surfacePosition;
layout(set = 0, binding = 7) uniform sampler2D surfaceNormal;
layout(set = 0, binding = 8, rgba32f) uniform image2D exitance;

layout(push_constant) uniform Push {
  uint site;
};

void main() {
  ivec2 pixel = pixelOfInvocation();
  bool inside = all(lessThan(pixel, imageSize(exitance)));
  vec4 surface = inside ? texelFetch(surfacePosition, pixel, 0) : vec4(0.0);
  bool covered = surface.w > 0.0;
  ObjectData body = objects[covered ? uint(surface.w) - 1u : 0u];
  bool here = covered && body.clusters.z != 0u && isSummedAtFragments(body, site);
  vec4 normal = inside ? texelFetch(surfaceNormal, pixel, 0) : vec4(0.0);
  vec4 known = inside ? imageLoad(exitance, pixel) : vec4(0.0);
  vec3 better = corrected(known.rgb, surface.xyz, normal.w * normal.xyz,
                          insideOf(body),
                          here ? body.clusters.x : noNode, body.clusters.y);
  if (here) imageStore(exitance, pixel, vec4(better, known.a));
}
