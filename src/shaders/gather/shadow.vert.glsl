// Depth of the scene as a light sees it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };

layout(push_constant) uniform Push { uint view; };

void main() {
  gl_Position = frame.shadowViews[view] * vec4(positions[gl_VertexIndex].xyz, 1.0);
}
