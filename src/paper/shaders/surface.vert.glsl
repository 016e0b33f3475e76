// The surface that the camera sees, by its corners in the atlas.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "paper/shaders/lib/place.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 2) readonly buffer Normals { vec4 normals[]; };
layout(std430, set = 0, binding = 3) readonly buffer Corners { AtlasCorner corners[]; };
layout(std430, set = 0, binding = 4) readonly buffer Exitance { vec4 exitances[]; };
layout(std430, set = 0, binding = 5) readonly buffer Charts { ChartPlace charts[]; };

layout(push_constant) uniform Push { vec2 jitter; };  // in clip space

layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) out vec2 place;
layout(location = 3) out vec4 exitance;
layout(location = 4) flat out uint object;
layout(location = 5) flat out float side;

void main() {
  AtlasCorner corner = corners[gl_VertexIndex];
  position = positions[corner.vertex].xyz;
  normal = normals[corner.vertex].xyz;
  side = normals[corner.vertex].w;
  place = nearPlace(corner, charts[corner.chart]);
  exitance = exitances[corner.vertex];
  object = corner.object;
  gl_Position = frame.worldToClip * vec4(position, 1.0);
  gl_Position.xy += jitter * gl_Position.w;
}
