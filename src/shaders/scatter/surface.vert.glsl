// The surface that the camera sees. The shader reads indices itself, so that triangles are known by theirs.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Indices { uint indices[]; };
layout(std430, set = 0, binding = 2) readonly buffer Positions { vec4 positions[]; };

layout(push_constant) uniform Push { vec2 jitter; };  // in clip space

layout(location = 0) flat out uint triangle;

void main() {
  triangle = uint(gl_VertexIndex) / 3u;
  gl_Position = frame.worldToClip * vec4(positions[indices[gl_VertexIndex]].xyz, 1.0);
  gl_Position.xy += jitter * gl_Position.w;
}
