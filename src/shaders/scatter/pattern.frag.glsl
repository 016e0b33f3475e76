// The paper's FTF: the near block of the pattern summed for every visible fragment, on top of what
// the far samples gave the vertices.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_PATTERN 6
#define BINDING_POSITION 7
#define BINDING_FLUX 8
#include "lib/scatter.glsl"

layout(set = 0, binding = 1) uniform sampler2D surfacePosition;
layout(set = 0, binding = 2) uniform sampler2D surfacePlace;
layout(set = 0, binding = 3) uniform sampler2D farExitance;

layout(location = 0) out vec4 exitance;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 surface = texelFetch(surfacePosition, pixel, 0);
  exitance = vec4(0.0);
  if (surface.w > 0.0) {
    uint object = uint(surface.w) - 1u;
    vec3 near = nearSum(surface.xyz, object, texelFetch(surfacePlace, pixel, 0).xy);
    exitance = vec4(near + texelFetch(farExitance, pixel, 0).rgb, 1.0);
  }
}
