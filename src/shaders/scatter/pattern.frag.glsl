// The paper's FTF: the pattern summed for every visible fragment.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_PATTERN 6
#define BINDING_POSITION 7
#define BINDING_FLUX 8
#define BINDING_FAR_POSITION 9
#define BINDING_FAR_FLUX 10
#include "lib/scatter.glsl"
#include "lib/place.glsl"

layout(set = 0, binding = 1) uniform sampler2D surfacePosition;
layout(set = 0, binding = 2) uniform sampler2D surfacePlace;

layout(std430, set = 0, binding = 11) readonly buffer Charts { ChartPlaces charts[]; };

layout(location = 0) out vec4 exitance;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 surface = texelFetch(surfacePosition, pixel, 0);
  exitance = vec4(0.0);
  if (surface.w > 0.0) {
    uint object = uint(surface.w) - 1u;
    vec4 place = texelFetch(surfacePlace, pixel, 0);
    vec2 farPlace = farPlaceOf(place.xy, charts[uint(place.z)]);
    exitance = vec4(patternSum(surface.xyz, object, place.xy, farPlace, place.w), 1.0);
  }
}
