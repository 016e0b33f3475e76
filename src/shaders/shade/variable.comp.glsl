// A variable of the pixels' centres as it is handed out: its value, and 1 where a surface is seen.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/variable.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0, rgba32f) readonly uniform image2D places;  // passes::SeenCentres
layout(set = 0, binding = 1) uniform sampler2D values;
layout(set = 0, binding = 2, rgba32f) writeonly uniform image2D variable;

layout(push_constant) uniform Push {
  vec4 depth;   // of a place: its product with xyz, plus w
  vec3 origin;  // of the scene, mm
  uint kind;    // as in shared/variable.h
};

vec3 valueAt(ivec2 pixel, vec4 place) {
  switch (kind) {
    case variablePlace:
      return place.xyz + origin;
    case variableDepth:
      return vec3(dot(depth.xyz, place.xyz) + depth.w);
    case variableObject:
      return vec3(place.w - 1.0);
    case variableLast:
      return vec3(texelFetch(values, pixel, 0).w);
    default:
      return texelFetch(values, pixel, 0).xyz;
  }
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(variable)))) return;
  vec4 place = imageLoad(places, pixel);
  bool isSeen = place.w > 0.0;
  imageStore(variable, pixel, isSeen ? vec4(valueAt(pixel, place), 1.0) : vec4(0.0));
}
