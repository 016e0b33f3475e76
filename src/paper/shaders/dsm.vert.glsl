// The mesh drawn into its atlas.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "paper/shaders/shared/atlas.h"

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 2) readonly buffer Normals { vec4 normals[]; };
layout(std430, set = 0, binding = 3) readonly buffer Corners { AtlasCorner corners[]; };

layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) flat out uint object;

void main() {
  AtlasCorner corner = corners[gl_VertexIndex];
  position = positions[corner.vertex].xyz;
  normal = normals[corner.vertex].xyz;
  object = corner.object;
  gl_Position = vec4(2.0 * vec2(corner.u, corner.v) - 1.0, 0.5, 1.0);
}
