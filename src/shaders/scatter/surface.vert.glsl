// The surface that the camera sees.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "shared/mesh.h"
#include "lib/place.glsl"

layout(constant_id = 0) const uint exitanceAtVertices = 0u;

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 2) readonly buffer Normals { vec4 normals[]; };
layout(std430, set = 0, binding = 3) readonly buffer Corners { AtlasCorner corners[]; };
layout(std430, set = 0, binding = 4) readonly buffer Exitance { vec4 exitances[]; };

layout(std430, set = 0, binding = 5) readonly buffer Charts { ChartPlaces charts[]; };

layout(push_constant) uniform Push { vec2 jitter; };  // in clip space

layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) out vec4 value;  // exitance; or near place and direction along +y
layout(location = 3) flat out uint object;
layout(location = 4) flat out uint chart;

void main() {
  AtlasCorner corner = corners[gl_VertexIndex];
  position = positions[corner.vertex].xyz;
  normal = normals[corner.vertex].xyz;
  object = corner.object;
  chart = corner.chart;
  value = exitanceAtVertices != 0u
              ? exitances[corner.vertex]
              : vec4(nearPlaceOf(vec2(corner.u, corner.v), charts[chart]), corner.alongU, corner.alongV);
  gl_Position = frame.worldToClip * vec4(position, 1.0);
  gl_Position.xy += jitter * gl_Position.w;
}
