// The paper's FTF: the near block of the pattern summed for every visible fragment, on top of what
// the far samples gave the vertices. One medium at a time.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_PATTERN 6
#define BINDING_POSITION 7
#define BINDING_FLUX 8
#include "paper/shaders/lib/pattern_sum.glsl"

layout(set = 0, binding = 1) uniform sampler2D surfacePosition;
layout(set = 0, binding = 2) uniform sampler2D surfacePlace;
layout(set = 0, binding = 3) uniform sampler2D farExitance;

layout(push_constant) uniform Push { uint medium; };

layout(location = 0) out vec4 exitance;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 surface = texelFetch(surfacePosition, pixel, 0);
  // Software devices go on after `discard`, but not through a branch that none of a group takes.
  if (surface.w != 0.0 && objects[uint(surface.w) - 1u].table.x == medium) {
    vec3 near = nearSum(surface.xyz, media[medium], texelFetch(surfacePlace, pixel, 0).xy);
    exitance = vec4(near, float(nearEvaluations())) + texelFetch(farExitance, pixel, 0);
  } else {
    discard;
  }
}
