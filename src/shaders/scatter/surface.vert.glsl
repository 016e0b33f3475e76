// The surface that the camera sees.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 2) readonly buffer Normals { vec4 normals[]; };
layout(std430, set = 0, binding = 3) readonly buffer ObjectOf { uint objectOf[]; };
layout(std430, set = 0, binding = 4) readonly buffer Exitance { vec4 exitances[]; };

layout(push_constant) uniform Push { vec2 jitter; };  // in clip space

layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) out vec4 exitance;
layout(location = 3) flat out uint object;
layout(location = 4) flat out float side;

void main() {
  position = positions[gl_VertexIndex].xyz;
  normal = normals[gl_VertexIndex].xyz;
  side = normals[gl_VertexIndex].w;
  exitance = exitances[gl_VertexIndex];
  object = objectOf[gl_VertexIndex];
  gl_Position = frame.worldToClip * vec4(position, 1.0);
  gl_Position.xy += jitter * gl_Position.w;
}
