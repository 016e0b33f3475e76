// As scatter/surface.vert.glsl, for surfaces with holes.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_VERTEX_ATTRIBUTES 3
#include "lib/cutout_vertex.glsl"
#include "lib/frame.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Indices { uint indices[]; };
layout(std430, set = 0, binding = 2) readonly buffer Positions { vec4 positions[]; };

layout(push_constant) uniform Push { vec2 jitter; };  // in clip space

layout(location = 3) flat out uint triangle;

void main() {
  uint vertex = indices[gl_VertexIndex];
  triangle = uint(gl_VertexIndex) / 3u;
  passOn(vertex);
  gl_Position = frame.worldToClip * vec4(positions[vertex].xyz, 1.0);
  gl_Position.xy += jitter * gl_Position.w;
}
