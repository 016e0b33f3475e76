// Depth of the scene as a light sees it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/mesh.h"

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 3) readonly buffer Corners { AtlasCorner corners[]; };

layout(push_constant) uniform Push { mat4 worldToClip; };

void main() {
  gl_Position = worldToClip * vec4(positions[corners[gl_VertexIndex].vertex].xyz, 1.0);
}
