// Depth of the scene as a light sees it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "shared/mesh.h"

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 3) readonly buffer Corners { AtlasCorner corners[]; };

layout(push_constant) uniform Push { uint view; };

void main() {
  gl_Position = frame.shadowViews[view] * vec4(positions[corners[gl_VertexIndex].vertex].xyz, 1.0);
}
