// The surface that the camera sees, with the pattern summed in the vertex stage itself.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_PATTERN 6
#define BINDING_POSITION 7
#define BINDING_FLUX 8
#define BINDING_FAR_POSITION 9
#define BINDING_FAR_FLUX 10
#include "lib/frame.glsl"
#include "lib/scatter.glsl"
#include "lib/place.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 2) readonly buffer Normals { vec4 normals[]; };
layout(std430, set = 0, binding = 3) readonly buffer Corners { AtlasCorner corners[]; };
layout(std430, set = 0, binding = 11) readonly buffer Charts { ChartPlaces charts[]; };

layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) out vec3 exitance;
layout(location = 3) flat out uint object;

void main() {
  AtlasCorner corner = corners[gl_VertexIndex];
  ChartPlaces chart = charts[corner.chart];
  position = positions[corner.vertex].xyz;
  normal = normals[corner.vertex].xyz;
  object = corner.object;
  vec2 place = nearPlaceOf(vec2(corner.u, corner.v), chart);
  exitance = patternSum(position, object, place, farPlaceOf(place, chart),
                        atan(corner.alongV, corner.alongU));
  gl_Position = frame.worldToClip * vec4(position, 1.0);
}
