// What leaves through every cluster: M = M₁ + g α'φ / 2A, added to that of light which entered before.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#include "lib/boundary.glsl"
#include "lib/linear.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 3) readonly buffer Fluences { vec4 fluences[]; };
layout(std430, set = 0, binding = 4) buffer Latest { vec4 latest[]; };  // M₁, then M of this light
layout(std430, set = 0, binding = 5) buffer Exitances { vec4 exitances[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
  uint adds;  // 1: to what entered before
};

// Near the surface of what absorbs, diffusion has too much light. What leaves a half-space says by
// how much, over what diffusion from first or from second collisions says: within 1 % the same for
// both and for light from 0 and 60°, for albedos from 1 to 0.65 and η from 1 to 1.5.
vec3 ofHalfSpace(BoundaryMedium medium) {
  vec3 dark = 1.0 - medium.albedo.rgb;
  float a = medium.diffusion.w;
  return 1.0 / (1.0 + (1.0 - 0.47 / (a * a)) * dark / (1.0 + 3.6 * dark));
}

void main() {
  uint i = linearIndex();
  if (i >= clusterCount) return;
  BoundaryMedium medium = media[objects[ranges[i].object].table.x].inside;
  vec3 leaves = latest[i].rgb + ofHalfSpace(medium) * medium.albedo.rgb * fluences[i].rgb /
                                    (2.0 * medium.diffusion.w);
  leaves = max(leaves, vec3(0.0));
  latest[i] = vec4(leaves, 0.0);
  exitances[i] = vec4(adds != 0u ? exitances[i].rgb + leaves : leaves, 0.0);
}
