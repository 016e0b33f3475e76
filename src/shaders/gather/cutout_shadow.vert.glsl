// As gather/shadow.vert.glsl, for surfaces with holes.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_VERTEX_ATTRIBUTES 2
#include "lib/cutout_vertex.glsl"
#include "lib/frame.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };

layout(push_constant) uniform Push { uint view; };

void main() {
  passOn(uint(gl_VertexIndex));
  gl_Position = frame.shadowViews[view] * vec4(positions[gl_VertexIndex].xyz, 1.0);
}
