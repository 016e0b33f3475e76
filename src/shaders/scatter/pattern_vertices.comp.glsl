// The paper's VTF: the pattern summed once for every vertex.
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
#include "lib/linear.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 2) readonly buffer Corners { AtlasCorner corners[]; };  // one a vertex
layout(std430, set = 0, binding = 3) writeonly buffer Exitance { vec4 exitances[]; };

layout(std430, set = 0, binding = 11) readonly buffer Charts { ChartPlaces charts[]; };

layout(push_constant) uniform Push { uint vertexCount; };

void main() {
  uint i = linearIndex();
  if (i >= vertexCount) return;
  AtlasCorner corner = corners[i];
  ChartPlaces chart = charts[corner.chart];
  vec2 place = nearPlaceOf(vec2(corner.u, corner.v), chart);
  vec3 sum = patternSum(positions[i].xyz, corner.object, place, farPlaceOf(place, chart),
                        atan(corner.alongV, corner.alongU));
  exitances[i] = vec4(sum, 1.0);
}
